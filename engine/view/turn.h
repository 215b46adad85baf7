#pragma once
// Which way three positions turn, exactly.

#include <halftone/core/rounding.h>
#include <halftone/view/screen.h>

#include <cmath>

namespace halftone::view {

/// Twice the area of the triangle, in square pixels, as rounding has it: positive where the corners run
/// clockwise as seen, y pointing down.
inline double turn(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline int sign(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// The sign of a sum of all six products of coordinates.
int sign_of_products(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);

/// The sign of what turn() would be without rounding: 1, 0 or -1. Exact as long as no product of two
/// coordinates, or of two differences of them, is below 2^-969 and not 0, so that the error of each is a
/// number.
inline int exact_turn(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  // Between neighbours, which may be near to each other: then rounding still knows.
  const double left = (b.x - a.x) * (c.y - b.y), right = (b.y - a.y) * (c.x - b.x);
  // A difference has the sign that it would have without rounding, and so has a product.
  if (left == 0 || right == 0 || (left > 0) != (right > 0)) return sign(left - right);
  const double difference = left - right;
  if (std::abs(difference) > core::gamma(4) * std::abs(left + right)) return sign(difference);
  return sign_of_products(a, b, c);
}

} // namespace halftone::view
