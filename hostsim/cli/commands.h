#pragma once
// The commands of halftone, the host.

#include <halftone/terminal/program.h>

namespace halftone::cli {

using terminal::ArgumentError;
using terminal::Command;
using terminal::ExitCode;
using terminal::OutputError;

Command add_render(CLI::App& program);
Command add_check(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_info(CLI::App& program);

} // namespace halftone::cli
