#pragma once
// The emulated frame buffer: its memory, its registers, and what each command does to them
// (docs/protocol.md).

#include <halftone/device/clock.h>

#include <halftone/protocol/decoder.h>
#include <halftone/protocol/fault.h>
#include <halftone/protocol/opcodes.h>

#include <array>
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

using Pixel = std::array<std::uint8_t, protocol::channels>; ///< red, green, blue

/// The overlay plane or the cursor, on top of the image.
struct Layer {
  bool on = false;
  std::uint8_t blink = 0; ///< fields for which it is shown, and then not; 0: always shown
  Pixel color{};

  bool operator==(const Layer&) const = default;
};

/// As at power-on unless told otherwise. Counters wrap at 2^32.
struct Registers {
  Rectangle window;
  std::uint16_t x = 0; ///< where the next pixel goes: a place on the screen, inside the window
  std::uint16_t y = 0;
  std::uint8_t written = 0; ///< image buffer, 0 or 1
  std::uint8_t shown = 0;
  Pixel write_mask{0xFF, 0xFF, 0xFF};

  Pixel read_mask{0xFF, 0xFF, 0xFF};
  std::uint16_t pan_x = 0; ///< of the image, at the top left of the screen
  std::uint16_t pan_y = 0;
  std::uint8_t zoom = 0; ///< a pixel is shown 2^zoom times across and down
  bool blank = false;
  std::uint8_t border = 0; ///< pixels at every side
  Pixel border_color{};
  Layer overlay;
  Layer cursor;
  std::uint16_t cursor_x = 0; ///< top left of the pattern on the screen
  std::uint16_t cursor_y = 0;

  protocol::Fault error = protocol::Fault::none; ///< the first since the reset
  std::uint32_t error_sequence = 0;              ///< of the command in error
  std::uint32_t errors = 0;
  std::uint32_t commands = 0; ///< executed since the reset, without queries
  std::uint32_t skipped = 0;  ///< damaged bytes

  bool operator==(const Registers&) const = default;
};

using Bytes = std::vector<std::uint8_t>;
using Lut = std::array<std::uint8_t, 256>;

inline constexpr std::size_t image_size =
    std::size_t{protocol::screen_width} * protocol::screen_height * protocol::channels;
inline constexpr std::size_t overlay_size = std::size_t{protocol::screen_width} * protocol::screen_height / 8;

/// The tables at power-on: each value stands for itself.
Lut linear_lut();

/// The state is there to be looked at and copied; commands alone change it.
struct Device {
  Registers registers;
  std::array<Bytes, 2> images{Bytes(image_size), Bytes(image_size)}; ///< pixels in rows from the top
  Bytes overlay = Bytes(overlay_size); ///< a bit a pixel, the highest at the left, rows from the top
  std::array<std::uint8_t, 32> cursor_pattern{}; ///< 16 rows of 16 bits, the highest at the left
  std::array<Lut, protocol::channels> luts{linear_lut(), linear_lut(), linear_lut()};
  Clock clock;

  /// Executes a command and appends its replies, if any, to a stream. A rejection sets the error status and
  /// touches nothing else but the clock.
  void execute(const protocol::Item& item, Bytes& replies);

  /// The same where nobody hears the replies: none are made.
  void execute(const protocol::Item& item);

  bool operator==(const Device&) const = default;
};

} // namespace halftone::device
