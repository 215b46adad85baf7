#include <halftone/render/quantise.h>

#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace core = halftone::core;
namespace render = halftone::render;
namespace scene = halftone::scene;
namespace shade = halftone::shade;
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

TEST_CASE("levels are found by their least radiance as by the curve") {
  std::mt19937_64 random(11);
  for (const scene::Transfer transfer : {scene::Transfer::linear, scene::Transfer::srgb})
    for (const double exposure : {1.0, 0.37, 3e20, 1e-30}) {
      scene::Image image;
      image.transfer = transfer;
      image.exposure = exposure;
      const render::Quantiser quantised(image);
      const auto check = [&](double radiance) {
        INFO("exposure " << exposure << ", radiance " << radiance);
        REQUIRE(static_cast<int>(quantised(radiance)) == static_cast<int>(quantise(radiance, image)));
      };
      for (const double radiance :
           {0.0, 1 / exposure, 2 / exposure, 1e300, 5e-324, std::numeric_limits<double>::infinity()})
        check(radiance);
      std::uniform_real_distribution<double> share(0, 1.1), fine(-1e-12, 1e-12);
      for (int k = 0; k < 100'000; ++k) check(share(random) / exposure);
      for (int level = 1; level < 256; ++level) // beside the steps
        for (int k = 0; k < 20; ++k) check(shade::radiance_at(level - 0.5, image) * (1 + fine(random)));
      const std::vector<core::Color> row{core::Color{0.2, 0.5, 0.9} / exposure, core::black};
      std::vector<std::uint8_t> rgb(6);
      quantised(row, rgb);
      for (int k = 0; k < 6; ++k) CHECK(rgb[k] == quantise(row[k / 3][k % 3], image));
    }
}
