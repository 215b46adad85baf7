#pragma once
// Where a stream of bytes goes in and replies come out: a device with its decoder.

#include <halftone/device/device.h>

#include <halftone/protocol/decoder.h>

#include <span>

namespace halftone::device {

struct Port {
  Device device;
  protocol::Decoder decoder{protocol::Direction::to_device};

  /// Executes what is complete, in pieces of any size, and appends the replies.
  void receive(std::span<const std::uint8_t> bytes, Bytes& replies);

  /// The stream ends, or its client is gone: an unfinished command is damage. The next byte begins a new
  /// stream to the same device.
  void end(Bytes& replies);
};

} // namespace halftone::device
