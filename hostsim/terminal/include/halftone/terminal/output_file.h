#pragma once
// Output files are whole or not there: they are written beside and renamed, and whether they can be written
// is asked before the work, not after it.

#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::terminal {

/// Throws OutputError where the file could not be written now: its folder is missing or may not be written,
/// or the name belongs to something that is not a regular file. Leaves no trace. A disk may still fill up
/// later.
void check_writable(const std::filesystem::path& file);

/// A file that a command will write.
struct Output {
  std::string option;         ///< that names it, for messages
  std::filesystem::path file; ///< empty: not asked for
};

/// The outputs of a command, of which all that were asked for must be writable now (check_writable), and none
/// the same file as an input or as another output, whatever they are called (ArgumentError). Inputs without a
/// name are none.
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::filesystem::path>& inputs);

/// Writes the bytes to a new file beside, and renames it. Throws OutputError, and then leaves nothing behind.
void write_whole(const std::filesystem::path& file, std::string_view bytes);

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the process. It is meant for the moment in which
/// files are written; at any other time there are none, and the process may die at once.
class SignalShelter {
public:
  SignalShelter();
  ~SignalShelter();
  SignalShelter(const SignalShelter&) = delete;
  SignalShelter& operator=(const SignalShelter&) = delete;

private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
  struct sigaction hang_up_ {};
};

} // namespace halftone::terminal
