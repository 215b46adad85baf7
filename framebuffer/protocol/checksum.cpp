#include <halftone/protocol/checksum.h>

#include <zlib.h>

namespace halftone::protocol {

std::uint32_t checksum(std::span<const std::uint8_t> bytes, std::uint32_t before) {
  if (bytes.empty()) return before; // zlib takes a null pointer for a request to start anew
  return static_cast<std::uint32_t>(crc32_z(before, bytes.data(), bytes.size()));
}

} // namespace halftone::protocol
