#include <halftone/render/quantise.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using halftone::render::quantise;
using halftone::scene::Image;
using halftone::scene::Transfer;

TEST_CASE("linear pictures are rounded half up") {
  Image image;
  image.transfer = Transfer::linear;
  CHECK(quantise(0, image) == 0);
  CHECK(quantise(1, image) == 255);
  CHECK(quantise(0.5, image) == 128); // 127.5 goes up
  CHECK(quantise(std::nextafter(0.5, 0.0), image) == 127);
  CHECK(quantise(7, image) == 255);
  CHECK(quantise(std::numeric_limits<double>::infinity(), image) == 255);
  image.exposure = 0.5;
  CHECK(quantise(1, image) == 128);
}

TEST_CASE("every one of the 256 levels comes back from the sRGB curve's inverse") {
  const Image image;
  for (int level = 0; level < 256; ++level) {
    const double encoded = level / 255.0;
    const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    INFO("level " << level);
    CHECK(quantise(linear, image) == level);
  }
}
