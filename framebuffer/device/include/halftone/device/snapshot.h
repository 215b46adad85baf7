#pragma once
// The whole state of a device as bytes, and a checksum of what a program can tell apart.

#include <halftone/device/device.h>

#include <optional>
#include <span>

namespace halftone::device {

/// The state without the clock's bus, big-endian, in the order of docs/protocol.md.
Bytes save(const Device& device);

/// The device that was saved, on an unlimited bus; nothing if the bytes are no snapshot: wrong size, or a
/// value that no command could have set.
std::optional<Device> restore(std::span<const std::uint8_t> bytes);

/// CRC-32 of memory, tables and registers, without error status, counters and clock: streams that leave the
/// same picture and writing position have the same sum.
std::uint32_t state_checksum(const Device& device);

} // namespace halftone::device
