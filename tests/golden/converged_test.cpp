#include "support/effort.h"

#include <halftone/reference/reference.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>
#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

// Below the rounding of 8-bit pictures: radiance against the brute-force renderer with many samples, on a
// lattice of pixels, in levels that are not rounded.

using namespace halftone;

namespace {

double rmse(const std::string& name, const render::Settings& settings, int lattice, int samples) {
  const scene::Scene scene = scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml");
  const scene::World world = scene::make_world(scene);
  const reference::Reference reference(world);
  reference::Counts counts;
  double sum = 0;
  int channels = 0;
  render::render(scene, settings, [&](const render::Row& row) {
    if (row.y % lattice != lattice / 2) return;
    for (int x = lattice / 2; x < scene.image.width; x += lattice) {
      const core::Color wanted = reference.pixel(x, row.y, samples, reference::Sampling::stratified, counts);
      for (int channel = 0; channel < 3; ++channel, ++channels) {
        const double off = shade::display_level(row.radiance[x][channel], scene.image) -
                           shade::display_level(wanted[channel], scene.image);
        sum += off * off;
      }
    }
  });
  return std::sqrt(sum / channels);
}

} // namespace

TEST_CASE("at quality 0.1 the error is less than 0.1 level", "[.][long]") {
  for (const std::string name :
       {"fig9a", "fig9b", "contact", "nested", "inside", "mirrors", "sliver", "cyclic", "opaque", "round"}) {
    const double error = rmse(name, {.quality = 0.1}, 7, 64);
    WARN(name << ": rmse " << error);
    CHECK(error < 0.1);
  }
}
