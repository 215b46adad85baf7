#include <halftone/cli/program.h>

#include "commands.h"

#include <CLI/CLI.hpp>

#include <array>
#include <iostream>
#include <string>

namespace halftone::cli {

namespace {

ExitCode parse_and_run(int argc, char** argv) {
  CLI::App program(
      "Renders scenes by scanlines, with ray tracing only where a scene needs it, through an emulated\n"
      "512 x 512 x 24 frame buffer.",
      "halftone");
  program.set_version_flag("--version", "halftone " HALFTONE_VERSION, "Print the version and exit");
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.require_subcommand(0, 1); // none is told below, in better words
  program.footer(
      "Example:\n  halftone render scenes/fig9a.toml\n\n"
      "Exit codes: 0 done, 1 the answer is no, 2 bad arguments, 3 bad input, 4 output cannot be written,\n"
      "5 device error, 6 timeout.");
  const std::array commands = {add_render(program), add_check(program), add_compare(program),
                               add_info(program)};

  for (CLI::App* command : program.get_subcommands({})) command->group("Commands");

  return guarded(
      [&] {
        try {
          program.parse(argc, argv);
        } catch (const CLI::Success& wish) { // --help, --version
          program.exit(wish);
          return ExitCode::done;
        } catch (const CLI::ParseError& error) {
          throw ArgumentError(std::string(error.what()) + " (try --help)");
        }
        for (const Command& command : commands)
          if (command.app->parsed()) return command.run();
        throw ArgumentError("a command is needed: render, check, compare or info (try --help)");
      },
      std::cerr);
}

} // namespace

int run_program(int argc, char** argv) {
  ExitCode code = parse_and_run(argc, argv);
  // A full disk or a closed pipe behind stdout must not look like success.
  if (!std::cout.flush() && code == ExitCode::done) {
    std::cerr << "halftone: standard output cannot be written\n";
    code = ExitCode::no_output;
  }
  return static_cast<int>(code);
}

} // namespace halftone::cli
