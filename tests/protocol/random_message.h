#pragma once
// Random messages made by the opcode table, and random damage.

#include <halftone/protocol/message.h>
#include <halftone/protocol/opcodes.h>

#include <cstdint>
#include <random>
#include <vector>

namespace halftone::test {

using Random = std::mt19937_64;

/// Not to be copied: the message's data are the vector's.
struct RandomMessage {
  protocol::Message message;
  std::vector<std::uint8_t> data;
};

/// From least to most, both included.
std::uint32_t between(Random& random, std::uint32_t least, std::uint32_t most);

/// Within all limits, which are met often; most rectangles and data are small, most places near the top left.
RandomMessage random_message(Random& random, const protocol::OpcodeEntry& entry);

/// Of an opcode that travels in this direction.
RandomMessage random_message(Random& random, protocol::Direction direction);

/// The stream with a few bytes changed, left out, put in, or doubled.
std::vector<std::uint8_t> damaged(Random& random, std::vector<std::uint8_t> stream);

} // namespace halftone::test
