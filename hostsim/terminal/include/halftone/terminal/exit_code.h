#pragma once
// What a program tells the shell.

#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace halftone::terminal {

enum class ExitCode {
  done = 0,
  no = 1, ///< the answer is "no": a comparison over its limit
  bad_arguments = 2,
  bad_input = 3,
  no_output = 4, ///< an output cannot be written, or shown
  device = 5,    ///< device or protocol error
  timeout = 6,
};

/// Arguments that do not go together, or that only a later stage can judge.
class ArgumentError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An output that is no file, such as standard output, cannot be written.
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The text on one line, with nothing in it that a terminal would obey: control characters become "?".
std::string one_line(std::string_view text);

/// Runs a command. An error of any room becomes one line on errors, "PROGRAM: ...", and its exit code; so
/// does a lack of memory or threads, with that of bad input. An exception that is none of them is a bug, and
/// passes through.
ExitCode guarded(std::string_view program, const std::function<ExitCode()>& command, std::ostream& errors);

} // namespace halftone::terminal
