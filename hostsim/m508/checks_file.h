#pragma once
// The CHECKS file of m508 assert (docs/assert.md).

#include <halftone/inspect/check.h>

#include <filesystem>
#include <vector>

namespace halftone::m508 {

/// The checks, with the pictures that they name, whose paths are relative to the file's folder. Throws
/// core::InputError with line, column and advice, png::ReadError for a picture that cannot be read.
std::vector<inspect::Check> read_checks(const std::filesystem::path& file);

} // namespace halftone::m508
