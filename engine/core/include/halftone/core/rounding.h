#pragma once
// Rounding bounds instead of tolerances: gamma(n) = n u / (1 - n u), u = 2^-53, bounds the relative error of
// n roundings in a row (N. Higham, "Accuracy and Stability of Numerical Algorithms", 2002, lemma 3.1).

#include <halftone/core/small_numbers.h>

namespace halftone::core {

constexpr double gamma(int roundings) { return roundings * unit_roundoff / (1 - roundings * unit_roundoff); }

} // namespace halftone::core
