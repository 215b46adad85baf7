// Argument reduction and Taylor or atanh series, as in J.-M. Muller, "Elementary Functions" (2016), chapters
// 11 and 4; written without tables and without fused operations so that every processor gives the same bits.

#include <halftone/core/elementary.h>

#include "exp_terms.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace halftone::core {

namespace {

// pi / 2 = high + low; high has 20 trailing zero bits, so k * high is exact for |k| < 2^20.
constexpr double half_pi_high = 0x1.921fb544p0;
constexpr double half_pi_low = 0x1.0b4611a626331p-34;

/// What ldexp and frexp do, without their calls where all numbers are normal: half of the time of exp.
double scaled(double x, int exponent) {
  if (exponent < -1000 || exponent > 1000) return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

struct Binary {
  double fraction = 0; ///< in [1/2, 1)
  int exponent = 0;
};

Binary binary(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52); // x > 0
  if (biased == 0 || biased == 2047) {
    Binary parts;
    parts.fraction = std::frexp(x, &parts.exponent);
    return parts;
  }
  return {std::bit_cast<double>((bits & 0xfffffffffffff) | std::uint64_t{1022} << 52), biased - 1022};
}

} // namespace

double exp(double x) {
  if (x < -745.2) return 0.0;
  if (x > 709.79) return std::numeric_limits<double>::infinity();
  const double k = (x * per_ln2 + to_integer) - to_integer;
  const double r = (x - k * ln2_high) - k * ln2_low;
  double sum = last_exp_term;
  for (const double term : exp_terms) sum = sum * r + term;
  const double fraction = r * r * sum + r;
  return scaled(1.0 + fraction, static_cast<int>(k));
}

double log(double x) {
  auto [m, exponent] = binary(x);
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

SinCos sin_cos(double angle) {
  const double k = (angle * std::numbers::inv_pi * 2 + to_integer) - to_integer;
  const double r = (angle - k * half_pi_high) - k * half_pi_low; // |r| <= pi / 4
  const double r2 = r * r;
  // Taylor to r^17 and r^18: the first terms left out are below 2^-60.
  double sine = 1.0 / (16.0 * 17.0), cosine = 1.0 / (17.0 * 18.0);
  for (double n = 15; n >= 3; n -= 2) {
    sine = (1 - r2 * sine) / ((n - 1) * n);
    cosine = (1 - r2 * cosine) / (n * (n + 1));
  }
  sine = r - r * r2 * sine;
  cosine = 1 - r2 * ((1 - r2 * cosine) / 2);
  switch (static_cast<int>(k) & 3) {
  case 0:
    return {sine, cosine};
  case 1:
    return {cosine, -sine};
  case 2:
    return {-sine, -cosine};
  default:
    return {-cosine, sine};
  }
}

} // namespace halftone::core
