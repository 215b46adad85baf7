#pragma once
// The slow twin of the device: written from docs/protocol.md a pixel at a time, with its replies by the naive
// encoder. It shares the decoder and the opcode numbers with the fast one, and nothing else.

#include "../protocol/naive_codec.h"

#include <halftone/protocol/decoder.h>

#include <array>
#include <vector>

namespace halftone::test {

class NaiveDevice {
public:
  /// A bus that needs so many picoseconds for a byte, and for each item of the stream besides.
  explicit NaiveDevice(std::uint64_t byte_picoseconds = 0, std::uint64_t item_picoseconds = 0)
      : byte_picoseconds_(byte_picoseconds),
        item_picoseconds_(item_picoseconds) {}

  Bytes execute(const protocol::Item& item);

  using Pixel = std::array<std::uint8_t, 3>;
  Pixel pixel(int buffer, std::uint32_t x, std::uint32_t y) const {
    return memory_.images.at(static_cast<std::size_t>(buffer)).at(y).at(x);
  }
  bool overlay_bit(std::uint32_t x, std::uint32_t y) const { return memory_.overlay.at(y).at(x); }
  Pixel shown(std::uint32_t x, std::uint32_t y) const; ///< on the screen
  std::uint64_t picoseconds() const { return picoseconds_; }
  bool holds(int buffer, const Bytes& image) const; ///< the same bytes as in an image buffer
  bool holds_overlay(const Bytes& bits) const;      ///< eight pixels a byte, the highest bit at the left

private:
  struct Layer {
    std::uint32_t on = 0, blink = 0;
    Pixel color{};
  };
  /// What a reset brings back.
  struct Memory {
    std::array<std::vector<std::array<Pixel, 512>>, 2> images{std::vector<std::array<Pixel, 512>>(512),
                                                              std::vector<std::array<Pixel, 512>>(512)};
    std::vector<std::array<bool, 512>> overlay = std::vector<std::array<bool, 512>>(512);
    std::array<std::array<std::uint8_t, 256>, 3> luts{};
    Bytes cursor_pattern = Bytes(32);
    std::array<std::uint32_t, 4> window{0, 0, 512, 512};
    std::uint32_t position = 0; ///< pixels since the window was set
    std::uint32_t written = 0, shown = 0;
    Pixel write_mask{255, 255, 255}, read_mask{255, 255, 255};
    std::uint32_t pan_x = 0, pan_y = 0, zoom = 1;
    bool blank = false;
    std::uint32_t border = 0;
    Pixel border_color{};
    Layer overlay_layer, cursor_layer;
    std::uint32_t cursor_x = 0, cursor_y = 0;
    std::uint32_t error = 0, error_sequence = 0, errors = 0, commands = 0, skipped = 0;
    Memory();
  };

  Bytes answer(const protocol::Message& query) const;
  void obey(const protocol::Message& command);
  void write(const Pixel& pixel);
  void put(std::uint32_t x, std::uint32_t y, const Pixel& pixel);
  void take_time(const protocol::Message& command, std::uint64_t pixels);
  bool is_lit(const Layer& layer) const;
  std::uint32_t field() const;

  Memory memory_;
  std::uint64_t byte_picoseconds_;
  std::uint64_t item_picoseconds_;
  std::uint64_t picoseconds_ = 0;
  std::uint64_t pixels_ = 0; ///< addressed by the command at hand
};

} // namespace halftone::test
