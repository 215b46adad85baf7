#pragma once
// Numbers as text that reads back with the same bits.

#include <halftone/core/vector.h>

#include <string>

namespace halftone::convert {

/// The shortest such decimal, always with a point or an exponent: TOML takes "3" for an integer.
std::string text(double number);

/// As in "[1.0, 2.0, 3.0]", or with other brackets.
std::string text(const core::Vec3& v, char open, char close);

} // namespace halftone::convert
