#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

using namespace halftone;

TEST_CASE("the table of levels follows the curve") {
  for (const scene::Transfer transfer : {scene::Transfer::linear, scene::Transfer::srgb})
    for (const double exposure : {1.0, 0.37, 3e20, 1e-30}) {
      scene::Image image;
      image.transfer = transfer;
      image.exposure = exposure;
      const shade::LevelTable level(image);
      for (int k = -10; k <= 10'100; ++k) {
        const double radiance = k / 1e4 / exposure;
        INFO("exposure " << exposure << ", radiance " << radiance);
        REQUIRE(level(radiance) == Approx(shade::display_level(radiance, image)).margin(0.1));
      }
    }
}

TEST_CASE("the radiance of a level is shown at it") {
  for (const scene::Transfer transfer : {scene::Transfer::linear, scene::Transfer::srgb}) {
    scene::Image image;
    image.transfer = transfer;
    image.exposure = 2.5;
    for (int half = 0; half <= 510; ++half)
      CHECK(shade::display_level(shade::radiance_at(half / 2.0, image), image) ==
            Approx(half / 2.0).margin(1e-4)); // the curve's two parts do not quite meet
  }
}
