#pragma once
// exp, log, pow, sine and cosine with the same bits on every processor. The C library chooses variants by CPU
// (with and without fused multiply-add), which may differ in the last bit; these use only +, -, *, / and
// exact scaling.

namespace halftone::core {

/// e^x, relative error below 2^-51; 0 below -745, infinity above 709.79.
double exp(double x);

/// Natural logarithm of x > 0, finite and normal; relative error below 2^-50.
double log(double x);

/// base^exponent for base >= 0 and finite exponent >= 0; 0^0 = 1. The relative error is below
/// (2 + |exponent * log(base)|) * 2^-50: good for shading, where results below 2^-60 do not matter.
double pow(double base, double exponent);

/// What exp and log are calculated with, also side by side (elementary-inl.h).
namespace elementary {

// ln 2 = high + low; high has 32 trailing zero bits, so k * high is exact for |k| < 2^20.
constexpr double ln2_high = 0x1.62e42feep-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;
constexpr double log2_e = 0x1.71547652b82fep+0;

/// Adding it leaves no fraction bits: to the nearest integer, for |x| < 2^51.
constexpr double to_integer = 0x1.8p52;

/// Terms of e^r - 1 - r over r^2 by ascending powers from the right; to r^13: the first term left out is r^14
/// / 14!, below 2^-57 for |r| <= ln(2) / 2.
constexpr double exp_terms[] = {1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0,
                                1 / 362880.0,     1 / 40320.0,     1 / 5040.0,     1 / 720.0,
                                1 / 120.0,        1 / 24.0,        1 / 6.0,        1 / 2.0};

/// log m = 2 atanh s, s = (m - 1) / (m + 1), |s| < 0.1716: s^21 / 21 is below 2^-57 of s.
constexpr double log_terms[] = {1 / 23.0, 1 / 21.0, 1 / 19.0, 1 / 17.0, 1 / 15.0, 1 / 13.0,
                                1 / 11.0, 1 / 9.0,  1 / 7.0,  1 / 5.0,  1 / 3.0};
constexpr double sqrt_half = 0x1.6a09e667f3bcdp-1;

} // namespace elementary

struct SinCos {
  double sin = 0;
  double cos = 0;
};

/// Of an angle in radians up to 2^10; each within 2^-52, and relative to its own size where the angle is not
/// within 2^-20 of a multiple of pi / 2.
SinCos sin_cos(double angle);

} // namespace halftone::core
