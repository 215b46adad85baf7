#pragma once
// What numbers of the format may be.

#include <halftone/core/small_numbers.h>

namespace halftone::scene {

/// Numbers are up to this in magnitude, and those that must be positive down to the other: products of five
/// of either kind fit a double. Coordinates are at least that or 0, so that two places are one, or the square
/// of their distance is not 0.
inline constexpr double largest_number = 1e60;
using core::smallest_number;

} // namespace halftone::scene
