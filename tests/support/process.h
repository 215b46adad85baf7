#pragma once
// The program as a user starts it: a process with arguments, a folder, an environment and, if asked for, a
// terminal.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace halftone::test {

struct Surroundings {
  std::filesystem::path folder = ".";   ///< the process's current one
  std::vector<std::string> environment; ///< NAME=VALUE, beside what the test itself has
  std::string out_file;                 ///< where stdout goes; empty: into Outcome::out
  bool terminal = false;                ///< stderr is one
  /// Called whenever something has come from stderr, with all of it so far; the signal that it returns is
  /// sent to the process, 0 is none.
  std::function<int(const std::string&)> on_stderr;
};

struct Outcome {
  int exit_code = -1; ///< -1 where a signal ended the process
  int signal = 0;
  std::string out;
  std::string err;
};

/// Runs halftone and waits for it, but no longer than two minutes (then SIGKILL). Throws std::system_error
/// where it cannot be started.
Outcome run_halftone(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

/// Whether this machine has pseudo-terminals.
bool has_terminals();

} // namespace halftone::test
