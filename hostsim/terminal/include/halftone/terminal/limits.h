#pragma once
// Checks of option values beyond what CLI11 has: its ranges let "nan" through, and a limit of nan is no
// limit.

#include <CLI/CLI.hpp>

namespace halftone::terminal {

/// A finite number, 0 or more.
CLI::Validator zero_or_more();

/// A whole number in decimal, from least to most: CLI11's range takes "010" for 8 and "0x2" for 2.
CLI::Validator whole(int least, int most);

/// A finite number above 0 and up to most.
CLI::Validator above_zero(double most);

} // namespace halftone::terminal
