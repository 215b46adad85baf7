#pragma once
// Signatures: facts about what a ray tree meets, as 64 mixed bits that are added. Equal facts give equal
// sums, in whatever order; different facts give the same sum with probability 2^-64.

#include <halftone/shade/albedo.h>

#include <bit>
#include <cstdint>

namespace halftone::trace {

/// SplitMix64 (G. Steele, D. Lea, C. Flood 2014): a bijection that mixes well.
constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// Two indices of at least -1 as one number.
constexpr std::uint64_t pair_of(int a, int b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

/// A cell of a pattern.
inline std::uint64_t signature_of(const shade::Cell& cell) {
  return mixed(mixed(std::bit_cast<std::uint64_t>(cell.a)) ^ std::bit_cast<std::uint64_t>(cell.b));
}

} // namespace halftone::trace
