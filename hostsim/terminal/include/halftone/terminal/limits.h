#pragma once
// Checks of option values beyond what CLI11 has: its ranges let "nan" through, and a limit of nan is no
// limit.

#include <CLI/CLI.hpp>

#include <cstdint>

namespace halftone::terminal {

/// A finite number, 0 or more.
CLI::Validator zero_or_more();

/// A whole number in decimal, from least to most: CLI11 takes "010" for 8, "0x2" for 2 and, where
/// numbers have no sign, "-1" for the largest one.
CLI::Validator whole(std::uint64_t least, std::uint64_t most);

/// A finite number above 0 and up to most.
CLI::Validator above_zero(double most);

} // namespace halftone::terminal
