// Argument reduction and Taylor or atanh series, as in J.-M. Muller, "Elementary Functions" (2016), chapters
// 11 and 4; written without tables and without fused operations so that every processor gives the same bits.

#include <halftone/core/elementary.h>

#include <cmath>
#include <limits>

namespace halftone::core {

namespace {

// ln 2 = high + low; high has 32 trailing zero bits, so k * high is exact for |k| < 2^20.
constexpr double ln2_high = 0x1.62e42feep-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;

} // namespace

double exp(double x) {
  if (x < -745.2) return 0.0;
  if (x > 709.79) return std::numeric_limits<double>::infinity();
  const double k = std::nearbyint(x * 0x1.71547652b82fep+0);
  const double r = (x - k * ln2_high) - k * ln2_low; // |r| <= ln(2) / 2
  // Taylor to r^13: the first term left out is r^14 / 14!, below 2^-57.
  double sum = 1.0 / 6227020800.0;
  constexpr double factorials[] = {479001600.0, 39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0,
                                   720.0,       120.0,      24.0,      6.0,      2.0};
  for (const double f : factorials) sum = sum * r + 1.0 / f;
  const double fraction = r * r * sum + r;
  return std::ldexp(1.0 + fraction, static_cast<int>(k));
}

double log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent); // in [1/2, 1)
  if (m < 0x1.6a09e667f3bcdp-1) {
    m *= 2;
    --exponent;
  }
  // log m = 2 atanh s, s = (m - 1) / (m + 1), |s| < 0.1716: s^21 / 21 is below 2^-57 of s.
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double sum = 1.0 / 23.0;
  for (int n = 21; n >= 3; n -= 2) sum = sum * s2 + 1.0 / n;
  const double log_m = 2.0 * s + 2.0 * s * s2 * sum;
  return exponent * ln2_high + (log_m + exponent * ln2_low);
}

double pow(double base, double exponent) {
  if (exponent == 0.0) return 1.0;
  if (base <= 0.0) return 0.0;
  return exp(exponent * log(base));
}

} // namespace halftone::core
