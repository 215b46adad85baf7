#pragma once
// m508 as a process, in a folder.

#include "support/process.h"
#include "support/scratch.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace halftone::test {

/// process.cpp starts HALFTONE_PROGRAM, which is m508 here.
inline Outcome run_m508(const Scratch& scratch, const std::vector<std::string>& arguments) {
  return run_halftone(arguments, {.folder = scratch.path()});
}

inline std::string as_text(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

} // namespace halftone::test
