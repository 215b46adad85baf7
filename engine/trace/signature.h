#pragma once
// Signatures: facts about what a ray tree meets, as 64 mixed bits that are added. Equal facts give equal
// sums, in whatever order; different facts give the same sum with probability 2^-64.

#include <halftone/core/mixed.h>
#include <halftone/shade/albedo.h>

#include <bit>
#include <cstdint>

namespace halftone::trace {

using core::mixed;

/// Two indices of at least -1 as one number.
constexpr std::uint64_t pair_of(int a, int b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

/// A cell of a pattern.
inline std::uint64_t signature_of(const shade::Cell& cell) {
  return mixed(mixed(std::bit_cast<std::uint64_t>(cell.a)) ^ std::bit_cast<std::uint64_t>(cell.b));
}

} // namespace halftone::trace
