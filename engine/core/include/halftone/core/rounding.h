#pragma once
// Rounding bounds instead of tolerances: gamma(n) = n u / (1 - n u), u = 2^-53, bounds the relative error of
// n roundings in a row (N. Higham, "Accuracy and Stability of Numerical Algorithms", 2002, lemma 3.1).

namespace halftone::core {

constexpr double gamma(int roundings) {
  const double u = 0x1p-53;
  return roundings * u / (1 - roundings * u);
}

} // namespace halftone::core
