// The scalar exp(), side by side for three numbers and one that is not used, for each instruction set (Google
// Highway).
//
// Invariant: the operations on a number are those of elementary.cpp in the same order. No operation is
// contracted to a fused one.

#include <halftone/core/exponential.h>

#include "exp_terms.h"

#include <halftone/core/elementary.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exponential.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace halftone::core::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

namespace hn = hwy::HWY_NAMESPACE;

Vec3 exp_of_three(const Vec3& numbers) {
  const hn::FixedTag<double, 4> d;
  const hn::Repartition<std::uint64_t, decltype(d)> bits;
  alignas(32) double at[4] = {numbers.x, numbers.y, numbers.z, 0};
  const auto x = hn::Load(d, at);
  // Beyond, 2^k need not be a normal number.
  if (!hn::AllTrue(d, hn::Lt(hn::Abs(x), hn::Set(d, 690))))
    return {exp(numbers.x), exp(numbers.y), exp(numbers.z)};
  const auto raised = hn::Add(hn::Mul(x, hn::Set(d, per_ln2)), hn::Set(d, to_integer));
  const auto k = hn::Sub(raised, hn::Set(d, to_integer));
  const auto r = hn::Sub(hn::Sub(x, hn::Mul(k, hn::Set(d, ln2_high))), hn::Mul(k, hn::Set(d, ln2_low)));
  auto sum = hn::Set(d, last_exp_term);
  for (const double term : exp_terms) sum = hn::Add(hn::Mul(sum, r), hn::Set(d, term));
  const auto fraction = hn::Add(hn::Mul(hn::Mul(r, r), sum), r);
  // The last bits of `raised` are those of k.
  const auto exponent = hn::Add(hn::BitCast(bits, raised), hn::Set(bits, 1023));
  const auto power = hn::BitCast(d, hn::ShiftLeft<52>(exponent));
  hn::Store(hn::Mul(hn::Add(hn::Set(d, 1), fraction), power), d, at);
  return {at[0], at[1], at[2]};
}

#endif

} // namespace halftone::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace halftone::core {

ExpOfThree exp_of_three(Simd simd) {
#if HWY_TARGETS & HWY_AVX3
  if (simd == Simd::avx512) return N_AVX3::exp_of_three;
#endif
#if HWY_TARGETS & HWY_AVX2
  if (simd >= Simd::avx2) return N_AVX2::exp_of_three;
#endif
  return [](const Vec3& x) { return Vec3{exp(x.x), exp(x.y), exp(x.z)}; };
}

} // namespace halftone::core

#endif
