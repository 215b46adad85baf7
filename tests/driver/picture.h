#pragma once

#include <halftone/driver/driver.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace halftone::test {

struct TestPicture {
  int width;
  int height;
  std::vector<std::uint8_t> rgb;

  std::span<const std::uint8_t> row(int y) const {
    const std::size_t size = static_cast<std::size_t>(width) * 3;
    return std::span(rgb).subspan(static_cast<std::size_t>(y) * size, size);
  }
};

/// No two rows alike, no byte black, so that whatever is missing shows.
inline TestPicture noise(int width, int height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  TestPicture picture{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  for (std::uint8_t& byte : picture.rgb) byte = static_cast<std::uint8_t>(1 + random() % 255);
  return picture;
}

inline void send(driver::Driver& driver, const TestPicture& picture) {
  driver.begin(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y) driver.send_row(y, picture.row(y));
}

} // namespace halftone::test
