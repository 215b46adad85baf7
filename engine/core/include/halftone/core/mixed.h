#pragma once
// Bits that stand for facts.

#include <cstdint>

namespace halftone::core {

/// SplitMix64 (G. Steele, D. Lea, C. Flood 2014): a bijection that mixes well.
constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

} // namespace halftone::core
