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

struct SinCos {
  double sin = 0;
  double cos = 0;
};

/// Of an angle in radians up to 2^10; each within 2^-52, and relative to its own size where the angle is not
/// within 2^-20 of a multiple of pi / 2.
SinCos sin_cos(double angle);

} // namespace halftone::core
