#pragma once
// An output file that is worth having at every moment, such as a recording: it is written while things
// happen, so that what was written before a crash is there.

#include <cstdint>
#include <filesystem>
#include <span>

#include <sys/types.h>

namespace halftone::terminal {

class GrowingFile {
public:
  /// Empties the file. Throws file::WriteError, as file::check_writable does.
  explicit GrowingFile(const std::filesystem::path& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// All of it is with the system afterwards. Throws file::WriteError, and then leaves the file as it was
  /// before the call, so that more may be appended where there is room again.
  void append(std::span<const std::uint8_t> bytes);

private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path file_;
  int descriptor_ = -1;
  off_t whole_ = 0; ///< size of what was appended, without what could not be written to its end
};

} // namespace halftone::terminal
