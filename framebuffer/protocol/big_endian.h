#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace halftone::protocol {

/// Writes the lowest bytes of a value, as many as there is room for, the highest of them first.
inline void store_big_endian(std::span<std::uint8_t> bytes, std::uint32_t value) {
  for (std::size_t i = bytes.size(); i-- > 0; value >>= 8) bytes[i] = static_cast<std::uint8_t>(value);
}

/// Reads at most 4 bytes.
inline std::uint32_t load_big_endian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

} // namespace halftone::protocol
