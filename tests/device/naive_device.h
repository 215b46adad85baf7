#pragma once
// The slow twin of the device: a pixel at a time, and its replies by the naive encoder. It shares the decoder
// and the opcode numbers with the fast one, and nothing else.

#include "../protocol/naive_codec.h"

#include <halftone/protocol/decoder.h>

#include <array>
#include <vector>

namespace halftone::test {

class NaiveDevice {
public:
  Bytes execute(const protocol::Item& item);

  bool holds(const Bytes& image) const;

  using Pixel = std::array<std::uint8_t, 3>;
  Pixel pixel(std::uint32_t x, std::uint32_t y) const { return image_.at(y).at(x); }

private:
  Bytes execute(const protocol::Message& command);
  void write(Pixel pixel);
  void fill(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height, Pixel pixel);

  std::vector<std::array<Pixel, 512>> image_ = std::vector<std::array<Pixel, 512>>(512);
  std::array<std::uint32_t, 4> window_{0, 0, 512, 512};
  std::uint32_t written_ = 0; ///< pixels since the window was set
  std::uint32_t error_ = 0, error_sequence_ = 0, errors_ = 0, commands_ = 0, skipped_ = 0;
};

} // namespace halftone::test
