#pragma once
// The slow twin of encoder and decoder: framing written a second time from docs/protocol.md, on whole
// streams, a byte at a time and with a checksum of its own.

#include <halftone/protocol/decoder.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace halftone::test {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t naive_checksum(std::span<const std::uint8_t> bytes);

/// A frame of any opcode and payload.
Bytes naive_frame(std::uint8_t opcode, std::uint32_t sequence, const Bytes& payload);

/// All items of a stream that has ended, as text.
std::vector<std::string> naive_decode(const Bytes& stream, protocol::Direction direction);

/// An item as text: its place in the stream, and what it is.
std::string describe(const protocol::Item& item);

} // namespace halftone::test
