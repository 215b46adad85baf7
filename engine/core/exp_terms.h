#pragma once
// The numbers of exp(): x = k ln 2 + r, and the Taylor series of e^r from its end.

namespace halftone::core {

// ln 2 = high + low; high has 32 trailing zero bits, so k * high is exact for |k| < 2^20.
inline constexpr double ln2_high = 0x1.62e42feep-1;
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;
inline constexpr double per_ln2 = 0x1.71547652b82fep+0;

/// Adding it leaves no fraction bits: to the nearest integer, for |x| < 2^51.
inline constexpr double to_integer = 0x1.8p52;

// Taylor to r^13 with |r| <= ln(2) / 2: the first term left out is r^14 / 14!, below 2^-57.
inline constexpr double last_exp_term = 1.0 / 6227020800.0;
inline constexpr double exp_terms[] = {1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0,
                                       1.0 / 40320.0,     1.0 / 5040.0,     1.0 / 720.0,     1.0 / 120.0,
                                       1.0 / 24.0,        1.0 / 6.0,        1.0 / 2.0};

} // namespace halftone::core
