#pragma once
// Commands as the bytes that a client sends.

#include <halftone/protocol/message.h>

#include <cstdint>
#include <vector>

namespace halftone::test {

inline std::vector<std::uint8_t> bytes_of(const std::vector<protocol::Message>& messages) {
  std::vector<std::uint8_t> bytes;
  for (const protocol::Message& message : messages) append(bytes, message);
  return bytes;
}

/// The most that a command of so few bytes can ask for: 786 kB, in a row of the screen each.
inline const protocol::Message whole_read{protocol::Opcode::read, 2, {0, 0, 512, 512}, {}};
inline constexpr std::size_t whole_read_answer = 512 * (512 * 3 + 4 + 13); ///< in bytes

} // namespace halftone::test
