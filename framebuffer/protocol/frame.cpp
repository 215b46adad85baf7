#include "big_endian.h"

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/frame.h>

#include <algorithm>
#include <cassert>

namespace halftone::protocol {

void append(std::vector<std::uint8_t>& stream, const Frame& frame) {
  assert(frame.payload.size() <= payload_limit);
  const std::size_t start = stream.size();
  const std::size_t end_of_payload = header_size + frame.payload.size();
  stream.resize(start + end_of_payload + checksum_size);
  const std::span<std::uint8_t> bytes = std::span(stream).subspan(start);
  store_big_endian(bytes.first(2), sync_word);
  bytes[2] = frame.opcode;
  store_big_endian(bytes.subspan(3, 4), frame.sequence);
  store_big_endian(bytes.subspan(7, 2), static_cast<std::uint32_t>(frame.payload.size()));
  std::ranges::copy(frame.payload, bytes.begin() + header_size);
  store_big_endian(bytes.last(checksum_size), checksum(bytes.first(end_of_payload)));
}

} // namespace halftone::protocol
