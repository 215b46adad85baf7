// Numbers and vectors of space side by side, for the instruction set that a Highway source is being compiled
// for.
//
// Invariant: the operations on each are those of GLM in the same order, so results have the same bits (those
// of who uses them: tests/geometry/packet_test.cpp, tests/scan/flat_run_test.cpp). No operation is contracted
// to a fused one.

// Read once for each instruction set, which HWY_TARGET_TOGGLE tells apart.
#if defined(HALFTONE_CORE_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFTONE_CORE_VECTORS_INL_H
#undef HALFTONE_CORE_VECTORS_INL_H
#else
#define HALFTONE_CORE_VECTORS_INL_H
#endif

#include <halftone/core/vector.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace halftone::core::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many numbers as a vector of the processor has, up to eight.
using Tag = hn::CappedTag<double, 8>;
using V = hn::Vec<Tag>;
using M = hn::Mask<Tag>;

HWY_INLINE V all(double value) { return hn::Set(Tag(), value); }
HWY_INLINE M none() { return hn::MaskFromVec(hn::Zero(Tag())); }
HWY_INLINE V chosen(M mask, V yes, V no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE M and_not(M a, M b) { return hn::AndNot(b, a); } // a without b
HWY_INLINE bool any(M mask) { return !hn::AllFalse(Tag(), mask); }

struct V3 {
  V x, y, z;
};

HWY_INLINE V3 all(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE V3 chosen(M mask, V3 yes, V3 no) {
  return {chosen(mask, yes.x, no.x), chosen(mask, yes.y, no.y), chosen(mask, yes.z, no.z)};
}
HWY_INLINE V3 plus(V3 a, V3 b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE V3 minus(V3 a, V3 b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE V3 times(V3 a, V s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE V3 times(V3 a, V3 b) { return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)}; }
HWY_INLINE V3 over(V3 a, V s) { return {hn::Div(a.x, s), hn::Div(a.y, s), hn::Div(a.z, s)}; }
HWY_INLINE V dot(V3 a, V3 b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE V3 normalized(V3 a) { return times(a, hn::Div(all(1), hn::Sqrt(dot(a, a)))); }

} // namespace halftone::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
