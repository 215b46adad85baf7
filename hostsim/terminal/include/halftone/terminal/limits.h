#pragma once
// Checks of option values beyond what CLI11 has: its ranges let "nan" through, and a limit of nan is no
// limit.

#include <halftone/terminal/arguments.h>

#include <cstdint>
#include <string>
#include <vector>

namespace halftone::terminal {

/// A finite number, 0 or more.
Check zero_or_more();

/// A whole number in decimal, from least to most: CLI11 takes "010" for 8, "0x2" for 2 and, where
/// numbers have no sign, "-1" for the largest one.
Check whole(std::uint64_t least, std::uint64_t most);

/// A finite number above 0 and up to most.
Check above_zero(double most);

/// One of these; there is at least one.
Check one_of(const std::vector<std::string>& names);

/// As in "render, check or compare".
std::string alternatives(const std::vector<std::string>& names);

} // namespace halftone::terminal
