#pragma once
// Framing: what every command and reply has around its payload, big-endian.
//
//   0  u16  sync word, "M5"
//   2  u8   opcode
//   3  u32  sequence number
//   7  u16  length of the payload, at most payload_limit
//   9       payload
//   9+n u32 checksum of all bytes before it

#include <halftone/protocol/opcodes.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace halftone::protocol {

inline constexpr std::uint16_t sync_word = 0x4D35;
inline constexpr std::size_t header_size = 9;
inline constexpr std::size_t checksum_size = 4;
inline constexpr std::size_t frame_limit = header_size + payload_limit + checksum_size;

/// A frame whose operands have not been looked at.
struct Frame {
  std::uint8_t opcode = 0;
  std::uint32_t sequence = 0;
  std::span<const std::uint8_t> payload; ///< not owned; at most payload_limit bytes
};

/// Appends the bytes of a frame to a stream.
void append(std::vector<std::uint8_t>& stream, const Frame& frame);

} // namespace halftone::protocol
