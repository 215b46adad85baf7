#pragma once
// The emulated frame buffer: its memory, its registers, and what each command does to them.

#include <halftone/protocol/decoder.h>
#include <halftone/protocol/fault.h>
#include <halftone/protocol/message.h>
#include <halftone/protocol/opcodes.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace halftone::device {

/// On the screen: x + width <= 512, y + height <= 512, width and height at least 1.
struct Rectangle {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t width = protocol::screen_width;
  std::uint16_t height = protocol::screen_height;

  bool operator==(const Rectangle&) const = default;
};

/// Everything but the image; as at power-on unless told otherwise. Counters wrap at 2^32.
struct Registers {
  Rectangle window;
  std::uint16_t x = 0; ///< where the next pixel goes: a place on the screen, inside the window
  std::uint16_t y = 0;
  protocol::Fault error = protocol::Fault::none; ///< the first since the reset
  std::uint32_t error_sequence = 0;              ///< of the command in error
  std::uint32_t errors = 0;
  std::uint32_t commands = 0; ///< executed since the reset, without queries
  std::uint32_t skipped = 0;  ///< damaged bytes

  bool operator==(const Registers&) const = default;
};

/// The state is there to be looked at and copied; commands alone change it.
struct Device {
  Registers registers;
  /// Red, green, blue of each pixel, rows from the top.
  std::vector<std::uint8_t> image = std::vector<std::uint8_t>(std::size_t{protocol::screen_width} *
                                                              protocol::screen_height * protocol::channels);

  /// Executes a command and appends its replies, if any, to a stream. A rejection sets the error status and
  /// touches nothing else.
  void execute(const protocol::Item& item, std::vector<std::uint8_t>& replies);

  bool operator==(const Device&) const = default;
};

} // namespace halftone::device
