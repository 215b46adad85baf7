#include "against_reference.h"

#include <halftone/reference/reference.h>
#include <halftone/render/render.h>
#include <halftone/scene/world.h>
#include <halftone/shade/display.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace halftone::test {

namespace {

/// A pixel that is off by more levels is settled by more samples: 144 of a pattern at a horizon miss its
/// mean.
constexpr double disputed = 2;

struct Off {
  double rmse = 0;
  double largest = 0;
};

Off off_reference(const scene::Scene& scene) {
  const scene::World world = scene::make_world(scene);
  const reference::Reference reference(world);
  reference::Counts counts;
  Off off;
  double sum = 0;
  int channels = 0;
  render::render(scene, {.threads = 1}, [&](const render::Row& row) {
    if (row.y % 2 != 0) return;
    for (int x = 0; x < scene.image.width; x += 2) {
      const auto levels_off = [&](int samples) {
        const core::Color wanted =
            reference.pixel(x, row.y, samples, reference::Sampling::stratified, counts);
        core::Vec3 levels{0};
        for (int channel = 0; channel < 3; ++channel)
          levels[channel] = std::isfinite(row.radiance[x][channel])
                                ? shade::display_level(row.radiance[x][channel], scene.image) -
                                      shade::display_level(wanted[channel], scene.image)
                                : 255;
        return glm::abs(levels);
      };
      core::Vec3 levels = levels_off(12);
      if (core::max_component(levels) > disputed) levels = levels_off(96);
      sum += glm::dot(levels, levels);
      off.largest = std::max(off.largest, core::max_component(levels));
      channels += 3;
    }
  });
  off.rmse = std::sqrt(sum / channels);
  return off;
}

} // namespace

void add_picture(const scene::Scene& scene, const std::string& which, Tally& tally) {
  const Off off = off_reference(scene);
  std::ostringstream text;
  text << which << ", largest " << off.largest;
  tally.add(off.rmse, !(off.rmse < 1 && off.largest < 16), text.str());
}

} // namespace halftone::test
