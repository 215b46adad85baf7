// exp and log of elementary.h side by side, for the instruction set that a Highway source is being compiled
// for.
//
// Invariant: the operations on a number are those of elementary.cpp in the same order, so results have the
// same bits (tests/core/elementary_test.cpp, tests/scan/flat_run_test.cpp).

// Read once for each instruction set, which HWY_TARGET_TOGGLE tells apart.
#if defined(HALFTONE_CORE_ELEMENTARY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFTONE_CORE_ELEMENTARY_INL_H
#undef HALFTONE_CORE_ELEMENTARY_INL_H
#else
#define HALFTONE_CORE_ELEMENTARY_INL_H
#endif

#include <halftone/core/elementary.h>

#include <hwy/highway.h>

#include <iterator>

HWY_BEFORE_NAMESPACE();
namespace halftone::core::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// For x in [-690, 690]: where the scalar code needs no special case.
template<typename D, typename V = hn::Vec<D>>
HWY_INLINE V exp(D d, V x) {
  using namespace elementary;
  const hn::RebindToUnsigned<D> bits;
  const V shifted = hn::Add(hn::Mul(x, hn::Set(d, log2_e)), hn::Set(d, to_integer));
  const V k = hn::Sub(shifted, hn::Set(d, to_integer));
  const V r = hn::Sub(hn::Sub(x, hn::Mul(k, hn::Set(d, ln2_high))), hn::Mul(k, hn::Set(d, ln2_low)));
  V sum = hn::Set(d, exp_terms[0]);
  for (std::size_t n = 1; n < std::size(exp_terms); ++n)
    sum = hn::Add(hn::Mul(sum, r), hn::Set(d, exp_terms[n]));
  const V fraction = hn::Add(hn::Mul(hn::Mul(r, r), sum), r);
  // The last bits of `shifted` are those of k: to the exponent's place, which drops what stands before.
  const auto exponent = hn::ShiftLeft<52>(hn::Add(hn::BitCast(bits, shifted), hn::Set(bits, 1023)));
  return hn::Mul(hn::Add(hn::Set(d, 1.0), fraction), hn::BitCast(d, exponent));
}

/// For finite and normal x > 0.
template<typename D, typename V = hn::Vec<D>>
HWY_INLINE V log(D d, V x) {
  using namespace elementary;
  const hn::RebindToUnsigned<D> bits;
  const auto all = hn::BitCast(bits, x);
  const auto own = hn::And(all, hn::Set(bits, 0xfffffffffffff));
  V m = hn::BitCast(d, hn::Or(own, hn::Set(bits, std::uint64_t{1022} << 52)));
  // Behind the bits of 2^52 an integer is that number more.
  const auto biased = hn::Or(hn::ShiftRight<52>(all), hn::BitCast(bits, hn::Set(d, 0x1p52)));
  V exponent = hn::Sub(hn::BitCast(d, biased), hn::Set(d, 0x1p52 + 1022));
  const auto is_low = hn::Lt(m, hn::Set(d, sqrt_half));
  m = hn::IfThenElse(is_low, hn::Mul(m, hn::Set(d, 2.0)), m);
  exponent = hn::IfThenElse(is_low, hn::Sub(exponent, hn::Set(d, 1.0)), exponent);
  const V one = hn::Set(d, 1.0), two = hn::Set(d, 2.0);
  const V s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  const V s2 = hn::Mul(s, s);
  V sum = hn::Set(d, log_terms[0]);
  for (std::size_t n = 1; n < std::size(log_terms); ++n)
    sum = hn::Add(hn::Mul(sum, s2), hn::Set(d, log_terms[n]));
  const V twice = hn::Mul(two, s);
  const V log_m = hn::Add(twice, hn::Mul(hn::Mul(twice, s2), sum));
  return hn::Add(hn::Mul(exponent, hn::Set(d, ln2_high)),
                 hn::Add(log_m, hn::Mul(exponent, hn::Set(d, ln2_low))));
}

} // namespace halftone::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
