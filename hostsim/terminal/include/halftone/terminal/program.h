#pragma once
// What the two programs have in common: commands, their help, errors and exit codes. Programs alone print, to
// stdout and stderr.

#include <halftone/terminal/arguments.h>
#include <halftone/terminal/exit_code.h>

#include <functional>
#include <string>
#include <vector>

namespace halftone::terminal {

/// A command whose options and help are in the parser. run does the work once the arguments are parsed, and
/// throws what exit_code.h turns into a message and an exit code.
struct Command {
  Arguments arguments;
  std::function<ExitCode()> run;
};

struct Program {
  std::string name;
  std::string description;
  std::string example;                                             ///< a call, for --help
  std::vector<std::function<Command(Arguments program)>> commands; ///< each adds its own to the program
};

/// Parses the arguments and does what they ask for. Returns the exit code for the shell.
int run(const Program& program, int argc, char** argv);

} // namespace halftone::terminal
