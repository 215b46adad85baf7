#pragma once
// The CHECKS file of m508 assert (docs/assert.md).

#include <halftone/inspect/check.h>

#include <filesystem>
#include <string>
#include <vector>

namespace halftone::m508 {

struct ChecksFile {
  std::vector<inspect::Check> checks;
  std::vector<std::string> pictures; ///< that were read for them
};

/// The checks, with the pictures that they name, whose paths are relative to the file's folder. Throws
/// core::InputError with line, column and advice, png::ReadError for a picture that cannot be read.
ChecksFile read_checks(const std::filesystem::path& file);

} // namespace halftone::m508
