#pragma once
// What a command takes on the command line. CLI11 does the work behind this door: whatever includes it costs
// the compiler ten seconds more, and twice that with sanitizers.

#include <functional>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace halftone::terminal {

/// What is wrong with the text of an option's value, as in "expected a number above 0, found -1"; empty if
/// nothing is. limits.h has some.
using Check = std::function<std::string(const std::string& text)>;

/// An option while it is described. Belongs to the command that takes it.
class Option {
public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required();
  Option check(const Check& check);

  /// Of its value in --help, as in "OUT.png"; empty for none.
  Option type_name(const std::string& name);

private:
  CLI::Option* option_;
};

/// A command, or the program whose commands these are. Belongs to the parser, copies too.
class Arguments {
public:
  explicit Arguments(CLI::App& parser) : parser_(&parser) {}

  Arguments add_subcommand(const std::string& name, const std::string& description);

  /// Names as in "-o,--output", or "FILE" for an argument that is told by its place. value keeps what it has
  /// where the option is left out, and outlives the parser. Value is std::string, std::uint16_t,
  /// std::uint64_t, int or double, std::optional of one of the last three, or a vector of strings.
  template<typename Value>
  Option add_option(const std::string& names, Value& value, const std::string& description);

  void add_flag(const std::string& names, bool& value, const std::string& description);

  /// The end of --help.
  void footer(const std::string& text);

  /// Whether the command was asked for.
  bool parsed() const;

private:
  CLI::App* parser_;
};

} // namespace halftone::terminal
