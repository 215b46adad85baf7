#pragma once
// Whether output files can be written is asked before the work, not after it.

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace halftone::terminal {

/// A file that a command will write.
struct Output {
  std::string option;         ///< that names it, for messages
  std::filesystem::path file; ///< empty: not asked for
};

/// The outputs of a command, of which all that were asked for must be writable now (file::check_writable),
/// and none the same file as an input or as another output, whatever they are called (ArgumentError). Inputs
/// without a name are none.
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::filesystem::path>& inputs);

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the process: they wait. It is meant for the moment
/// in which files are written, and for a process of one thread; at any other time there are none, and the
/// process may die at once.
class SignalShelter {
public:
  SignalShelter();
  ~SignalShelter();
  SignalShelter(const SignalShelter&) = delete;
  SignalShelter& operator=(const SignalShelter&) = delete;

private:
  sigset_t before_{};
};

} // namespace halftone::terminal
