#pragma once
// The numbers of the byte format (docs/trace-format.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace halftone::recording {

/// As of PNG: a first byte that is no text, and line ends that a transfer as text would change.
inline constexpr std::array<std::uint8_t, 8> magic{0x89, 'M', '5', '0', '8', '\r', '\n', 0x1A};

enum class RecordType : std::uint8_t { data = 1, session_begin = 2, session_end = 3, state = 4, restart = 5 };

inline constexpr std::size_t record_header_size = 5; ///< type, length
inline constexpr std::size_t record_checksum_size = 4;
inline constexpr std::size_t state_size = 12;

/// Appends the lowest `size` bytes of a number, the highest first.
inline void put(std::vector<std::uint8_t>& bytes, std::uint64_t number, std::size_t size) {
  for (std::size_t i = size; i-- > 0;) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
}

/// At most 8 bytes as a number.
inline std::uint64_t get(std::span<const std::uint8_t> bytes) {
  std::uint64_t number = 0;
  for (const std::uint8_t byte : bytes) number = number << 8 | byte;
  return number;
}

} // namespace halftone::recording
