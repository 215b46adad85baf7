#include "against_reference.h"

#include <halftone/reference/reference.h>
#include <halftone/render/render.h>
#include <halftone/scene/world.h>
#include <halftone/shade/display.h>

#include <cmath>

namespace halftone::test {

double rmse_against_reference(const scene::Scene& scene) {
  const scene::World world = scene::make_world(scene);
  const reference::Reference reference(world);
  reference::Counts counts;
  double sum = 0;
  int channels = 0;
  render::render(scene, {.threads = 1}, [&](const render::Row& row) {
    if (row.y % 2 != 0) return;
    for (int x = 0; x < scene.image.width; x += 2) {
      const core::Color wanted = reference.pixel(x, row.y, 12, reference::Sampling::stratified, counts);
      for (int channel = 0; channel < 3; ++channel, ++channels) {
        const double off = shade::display_level(row.radiance[x][channel], scene.image) -
                           shade::display_level(wanted[channel], scene.image);
        sum += std::isfinite(row.radiance[x][channel]) ? off * off : 1e300;
      }
    }
  });
  return std::sqrt(sum / channels);
}

} // namespace halftone::test
