#pragma once
// Files are whole or not there: they are written beside and renamed. Knows nothing of what is in them.

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>

namespace halftone::file {

/// what() begins with the file's name.
class WriteError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws WriteError where the file could not be written now: its folder is missing or may not be written,
/// or the name belongs to something that is not a regular file. Leaves no trace. A disk may still fill up
/// later.
void check_writable(const std::filesystem::path& file);

/// Writes the bytes to a new file beside, and renames it. Throws WriteError, and then leaves nothing behind
/// and the old file as it was.
void write_whole(const std::filesystem::path& file, std::span<const std::byte> bytes);

} // namespace halftone::file
