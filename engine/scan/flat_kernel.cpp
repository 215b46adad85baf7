// FlatRun::radiance() for as many points as a vector has places (Google Highway): a root and a division
// for the eye and for each light, which take most of the time, are then taken together.
//
// Invariant: the operations on a point are those of FlatRun::radiance() and shade::direct_light() in the same
// order, so results have the same bits (flat_run_test.cpp). No operation is contracted to a fused one.

#include "flat_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flat_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <halftone/core/elementary-inl.h>
#include <halftone/core/vectors-inl.h>

#include <array>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace halftone::scan::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

namespace hn = hwy::HWY_NAMESPACE;
using namespace core::HWY_NAMESPACE;

/// Powers of bases that are below 1, or a rounding above it, where they are wanted; numbers elsewhere.
HWY_INLINE V power(V base, double exponent, M wanted) {
  if (exponent == 0) return all(1);
  base = chosen(wanted, base, all(1));
  const V at = hn::Mul(all(exponent), core::HWY_NAMESPACE::log(Tag(), base));
  // Where neither logarithm nor exponential needs a special case.
  const auto is_plain = hn::And(hn::Ge(base, all(std::numeric_limits<double>::min())), hn::Ge(at, all(-690)));
  if (hn::AllTrue(Tag(), is_plain)) return core::HWY_NAMESPACE::exp(Tag(), at);
  std::array<double, 8> numbers{};
  hn::StoreU(base, Tag(), numbers.data());
  for (double& number : numbers) number = core::pow(number, exponent);
  return hn::LoadU(Tag(), numbers.data());
}

void shade_flat(const FlatTerms& terms, const FlatPoints& points,
                std::span<core::Color, FlatPoints::capacity> radiance) {
  const Tag d;
  const scene::CameraFrame& camera = terms.camera;
  const V3 eye = all(camera.eye), normal = all(terms.normal), specular = all(terms.specular);
  const bool has_highlight = terms.specular != core::black;
  for (std::size_t from = 0; from < points.count; from += hn::Lanes(d)) {
    const V x = hn::LoadU(d, &points.x[from]), y = hn::LoadU(d, &points.y[from]);
    V3 albedo;
    hn::LoadInterleaved3(d, &points.albedo[from].r, albedo.x, albedo.y, albedo.z);
    const V across = hn::Sub(hn::Div(hn::Mul(all(2), x), all(camera.width)), all(1));
    const V upwards = hn::Sub(all(1), hn::Div(hn::Mul(all(2), y), all(camera.height)));
    const V3 direction =
        plus(plus(all(camera.forward), times(all(camera.right), across)), times(all(camera.up), upwards));
    const view::Linear& linear = terms.inverse_depth;
    const V inverse_depth =
        hn::Add(hn::Mul(all(linear.a), x), hn::Add(hn::Mul(all(linear.b), y), all(linear.c)));
    const V3 position = plus(eye, over(direction, inverse_depth));
    const V3 view = normalized(direction);
    V3 sum = times(albedo, all(terms.ambient));
    for (const scene::Light& light : terms.lights) {
      const V3 l = normalized(minus(all(light.position), position));
      const V n_l = hn::Min(hn::Max(dot(normal, l), all(0)), all(1));
      V3 reflected = times(albedo, n_l);
      if (has_highlight) {
        const V r_v = hn::Min(hn::Neg(dot(minus(times(normal, hn::Mul(all(2), n_l)), l), view)), all(1));
        const V off = hn::Mul(all(terms.shininess), hn::Sub(all(1), r_v));
        const auto shines = hn::And(hn::Gt(r_v, all(0)), hn::Lt(off, all(42)));
        if (any(shines)) {
          const V share = power(r_v, terms.shininess, shines);
          reflected = chosen(shines, plus(reflected, times(specular, share)), reflected);
        }
      }
      sum = plus(sum, times(all(light.color), reflected));
    }
    hn::StoreInterleaved3(sum.x, sum.y, sum.z, d, &radiance[from].r);
  }
}

#endif

} // namespace halftone::scan::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace halftone::scan {

ShadeFlat shade_flat_with([[maybe_unused]] core::Simd simd) {
#if HWY_TARGETS & HWY_AVX3
  if (simd == core::Simd::avx512) return N_AVX3::shade_flat;
#endif
#if HWY_TARGETS & HWY_AVX2
  if (simd == core::Simd::avx2) return N_AVX2::shade_flat;
#endif
  return nullptr;
}

} // namespace halftone::scan

#endif
