#pragma once
// The commands of the program. Each function adds its command, with options and help, to the parser; run does
// the work once the arguments are parsed, and throws what exit_code.h turns into a message and an exit code.

#include <halftone/cli/exit_code.h>

#include <CLI/CLI.hpp>

#include <functional>

namespace halftone::cli {

struct Command {
  const CLI::App* app = nullptr; ///< owned by the parser
  std::function<ExitCode()> run;
};

Command add_render(CLI::App& program);
Command add_check(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_info(CLI::App& program);

} // namespace halftone::cli
