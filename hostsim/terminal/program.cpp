#include <halftone/terminal/limits.h>
#include <halftone/terminal/program.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace halftone::terminal {

namespace {

/// As in "render, check or compare".
std::string names(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::App* command : parser.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return alternatives(names);
}

/// What the parser would let through, or say in words that do not help.
void check_arguments(const CLI::App& parser, int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] == '\0') // a script's variable that was not set
      throw ArgumentError("argument " + std::to_string(i) + " is empty (try --help)");
  if (argc < 2 || argv[1][0] == '-') return;
  const auto commands = parser.get_subcommands([](const CLI::App*) { return true; });
  if (std::ranges::none_of(commands, [&](const CLI::App* command) { return command->check_name(argv[1]); }))
    throw ArgumentError("unknown command \"" + std::string(argv[1]) + "\"; expected " + names(parser) +
                        " (try --help)");
}

ExitCode parse_and_run(const Program& program, int argc, char** argv) {
  CLI::App parser(program.description, program.name);
  parser.set_version_flag("--version", program.name + " " HALFTONE_VERSION, "Print the version and exit");
  parser.get_formatter()->label("SUBCOMMAND", "COMMAND");
  parser.require_subcommand(0, 1); // none is told below, in better words
  parser.footer(
      "Example:\n  " + program.example +
      "\n\n"
      "Exit codes: 0 done, 1 the answer is no, 2 bad arguments, 3 bad input, 4 output cannot be written,\n"
      "5 device error, 6 timeout.");
  std::vector<Command> commands;
  for (const auto& add : program.commands) commands.push_back(add(Arguments(parser)));
  for (CLI::App* command : parser.get_subcommands({})) command->group("Commands");

  return guarded(
      program.name,
      [&] {
        check_arguments(parser, argc, argv);
        try {
          parser.parse(argc, argv);
        } catch (const CLI::Success& wish) { // --help, --version
          parser.exit(wish);
          return ExitCode::done;
        } catch (const CLI::ParseError& error) {
          throw ArgumentError(std::string(error.what()) + " (try --help)");
        }
        for (const Command& command : commands)
          if (command.arguments.parsed()) return command.run();
        throw ArgumentError("a command is needed: " + names(parser) + " (try --help)");
      },
      std::cerr);
}

} // namespace

int run(const Program& program, int argc, char** argv) {
  ExitCode code = parse_and_run(program, argc, argv);
  // A full disk or a closed pipe behind stdout must not look like success.
  if (!std::cout.flush() && code == ExitCode::done) {
    std::cerr << program.name << ": standard output cannot be written\n";
    code = ExitCode::no_output;
  }
  return static_cast<int>(code);
}

} // namespace halftone::terminal
