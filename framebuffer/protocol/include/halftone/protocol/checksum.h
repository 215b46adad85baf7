#pragma once
// The one checksum of the protocol: CRC-32 as in zlib, PNG and Ethernet (ISO 3309).

#include <cstdint>
#include <span>

namespace halftone::protocol {

/// Of these bytes; `before` is the checksum of the bytes that come before them, so that rows can be added up.
std::uint32_t checksum(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

} // namespace halftone::protocol
