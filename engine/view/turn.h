#pragma once
// Which way three positions turn, exactly.

#include <halftone/view/screen.h>

namespace halftone::view {

/// Twice the area of the triangle, in square pixels, as rounding has it: positive where the corners run
/// clockwise as seen, y pointing down.
inline double turn(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The sign of what turn() would be without rounding: 1, 0 or -1. Exact as long as no product of two
/// coordinates is below 2^-969, so that the error of each is a number.
int exact_turn(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);

} // namespace halftone::view
