#include "support/effort.h"
#include "support/random_scene.h"
#include "support/transformed.h"

#include <halftone/render/render.h>

#include <catch2/catch.hpp>

#include <vector>

// No absolute length anywhere: a scene scaled by a power of two is the same picture, to the bit.

using namespace halftone;

namespace {

std::vector<core::Color> drawn(const scene::Scene& scene, const render::Settings& settings) {
  std::vector<core::Color> radiance;
  render::render(scene, settings, [&](const render::Row& row) {
    radiance.insert(radiance.end(), row.radiance.begin(), row.radiance.end());
  });
  return radiance;
}

} // namespace

TEST_CASE("a scene scaled by a power of two is the same picture, bit for bit, to the ends of the format") {
  const std::vector<render::Settings> all{{.mode = render::Mode::local},
                                          {.mode = render::Mode::scanline},
                                          {.mode = render::Mode::local, .lines = 3},
                                          {.mode = render::Mode::scanline, .lines = 3},
                                          {.mode = render::Mode::reference, .samples = 2}};
  for (std::uint64_t seed = 1; seed <= 12; seed += test::seed_step) {
    const scene::Scene scene = test::RandomScene(seed).make({9, true, true, seed % 4 == 0});
    for (const render::Settings& settings : all) {
      const std::vector<core::Color> expected = drawn(scene, settings);
      INFO("seed " << seed << ", mode " << render::name(settings.mode));
      for (const double by :
           {0x1p40, 0x1p-40, 0x1p190, 0x1p-190}) { // 10^57: numbers of the format go to 10^60
        INFO("scaled by " << by);
        CHECK(drawn(test::scaled(scene, by), settings) == expected);
      }
    }
  }
}
