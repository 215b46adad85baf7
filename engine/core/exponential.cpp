// exp() of elementary-inl.h for three numbers, and one that is not used, for each instruction set (Google
// Highway).
//
// Invariant: results have the bits of the scalar code.

#include <halftone/core/exponential.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exponential.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <halftone/core/elementary-inl.h>

HWY_BEFORE_NAMESPACE();
namespace halftone::core::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

namespace hn = hwy::HWY_NAMESPACE;

Vec3 exp_of_three(const Vec3& numbers) {
  const hn::FixedTag<double, 4> d;
  alignas(32) double at[4] = {numbers.x, numbers.y, numbers.z, 0};
  const auto x = hn::Load(d, at);
  // Beyond, exp() of vectors does not go.
  if (!hn::AllTrue(d, hn::Lt(hn::Abs(x), hn::Set(d, 690))))
    return {core::exp(numbers.x), core::exp(numbers.y), core::exp(numbers.z)};
  hn::Store(exp(d, x), d, at);
  return {at[0], at[1], at[2]};
}

#endif

} // namespace halftone::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace halftone::core {

ExpOfThree exp_of_three([[maybe_unused]] Simd simd) {
#if HWY_TARGETS & HWY_AVX3
  if (simd == Simd::avx512) return N_AVX3::exp_of_three;
#endif
#if HWY_TARGETS & HWY_AVX2
  if (simd == Simd::avx2) return N_AVX2::exp_of_three;
#endif
  return [](const Vec3& x) { return Vec3{exp(x.x), exp(x.y), exp(x.z)}; };
}

} // namespace halftone::core

#endif
