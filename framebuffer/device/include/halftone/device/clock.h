#pragma once
// The virtual clock: how long a stream of commands would have taken on a device and a bus of 1985. It depends
// on the stream and the bus alone, never on this machine.

#include <halftone/protocol/message.h>

#include <cstdint>
#include <string>

namespace halftone::device {

/// A link of its time. Bits per byte, start bits and handshakes are in the figures.
struct Bus {
  std::string name = "unlimited";
  std::uint64_t byte_picoseconds = 0;  ///< for each byte
  std::uint64_t frame_picoseconds = 0; ///< for each command besides: set-up of a transfer

  bool operator==(const Bus&) const = default;
};

/// Never goes back: at the end of its numbers, 2^64 - 1 picoseconds or 213 days, it stands still, and with it
/// the fields.
struct Clock {
  Bus bus;
  std::uint64_t picoseconds = 0; ///< since power-on

  /// The time of a command's bytes, damaged ones too.
  void transfer(std::uint64_t bytes);
  /// The time for which the device is busy with a command.
  void execute(const protocol::Message& command);
  /// Until so many more fields have begun.
  void wait(std::uint32_t fields);

  bool operator==(const Clock&) const = default;
};

/// Fields of 1/60 s that have begun since power-on, the first of them at 0 not counted.
std::uint32_t fields(const Clock& clock);

/// Pixels that a command addresses, which its cost depends on.
std::uint32_t pixels_of(const protocol::Message& command);

} // namespace halftone::device
