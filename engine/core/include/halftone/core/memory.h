#pragma once
// Bytes that containers hold, for reports.

#include <cstddef>
#include <vector>

namespace halftone::core {

/// Of the elements themselves, without what they point to.
template<typename Element>
std::size_t memory_of(const std::vector<Element>& elements) {
  return elements.capacity() * sizeof(Element);
}

inline std::size_t memory_of(const std::vector<bool>& bits) { return bits.capacity() / 8; }

/// And of what each element holds, as memory_of or a member says.
template<typename Element, typename Inner>
std::size_t memory_of(const std::vector<Element>& elements, Inner inner) {
  std::size_t bytes = memory_of(elements);
  for (const Element& element : elements) bytes += inner(element);
  return bytes;
}

} // namespace halftone::core
