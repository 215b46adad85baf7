#pragma once
// Commands and replies as values, and their way into and out of frames by the opcode table.

#include <halftone/protocol/fault.h>
#include <halftone/protocol/frame.h>
#include <halftone/protocol/opcodes.h>

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace halftone::protocol {

struct Message {
  Opcode opcode = Opcode::identify;
  std::uint32_t sequence = 0;
  /// The numbers of its layout in order, the rest 0; see index_of.
  std::array<std::uint32_t, operand_limit> operands{};
  /// The bytes of its pixels or text, empty if it has none. Not owned.
  std::span<const std::uint8_t> data;
};

/// Why something that was received is not a message.
struct Rejection {
  Fault fault = Fault::none;
  std::uint32_t sequence = 0; ///< of the frame; where it is damaged, of the last good frame before
  std::uint8_t opcode = 0;    ///< as received; 0 where it is damaged

  bool operator==(const Rejection&) const = default;
};

/// The message in a frame that travels in this direction, or what is wrong with it; its data are those of the
/// frame.
std::variant<Message, Rejection> parse(const Frame& frame, Direction direction);

/// Appends the bytes of a message to a stream. The message must be within the limits of its layout.
void append(std::vector<std::uint8_t>& stream, const Message& message);

} // namespace halftone::protocol
