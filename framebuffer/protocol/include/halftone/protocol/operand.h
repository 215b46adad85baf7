#pragma once
// What the operands of commands and replies are made of.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace halftone::protocol {

inline constexpr std::uint16_t screen_width = 512;  ///< pixels
inline constexpr std::uint16_t screen_height = 512; ///< rows
inline constexpr std::size_t channels = 3;          ///< bytes of a pixel: red, green, blue

/// Bytes of payload that a frame can carry. Bounds the memory of a decoder, and how much of a stream it may
/// hold back when a damaged length promises more than comes.
inline constexpr std::size_t payload_limit = 4096;

/// The largest number of operands in a layout.
inline constexpr std::size_t operand_limit = 8;

/// Integers are unsigned and big-endian. The others are data: they come last and reach to the end of the
/// payload, in units of unit_of bytes.
enum class OperandType {
  u8,
  u16,
  u32,
  pixels, ///< red, green, blue of each
  runs,   ///< length less 1, red, green, blue of each
  bytes,
  text ///< printable ASCII
};

struct Operand {
  std::string_view name;
  OperandType type;
  std::uint32_t least; ///< smallest value; for data, smallest count of units
  std::uint32_t most;  ///< largest value or count
  std::string_view meaning;
  int origin = -1;            ///< if not negative: the operand there plus this one is at most `together`
  std::uint32_t together = 0; ///< no meaning without an origin
};

/// The largest value or count that the operand may have beside these of its layout, which are in their limits
/// up to its origin.
constexpr std::uint32_t most_beside(const Operand& operand, std::span<const std::uint32_t> values) {
  if (operand.origin < 0) return operand.most;
  return std::min(operand.most, operand.together - values[static_cast<std::size_t>(operand.origin)]);
}

/// Bytes of a number; 0 for data, whose size varies.
constexpr std::size_t size_of(OperandType type) {
  switch (type) {
  case OperandType::u8:
    return 1;
  case OperandType::u16:
    return 2;
  case OperandType::u32:
    return 4;
  case OperandType::pixels:
  case OperandType::runs:
  case OperandType::bytes:
  case OperandType::text:
    break;
  }
  return 0;
}

/// Bytes of a unit of data.
constexpr std::size_t unit_of(OperandType type) {
  if (type == OperandType::pixels) return channels;
  if (type == OperandType::runs) return 1 + channels;
  return 1;
}

} // namespace halftone::protocol
