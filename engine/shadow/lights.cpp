#include <halftone/shadow/lights.h>

#include <halftone/geometry/position.h>

#include <algorithm>

namespace halftone::shadow {

std::vector<scene::Light> reaching_lights(const scene::World& world) {
  const std::vector<int> around_eye = geometry::solids_around(world, world.camera.eye);
  const auto is_shut_in = [&](const scene::Light& light) {
    const std::vector<int> around = geometry::solids_around(world, light.position);
    return std::any_of(around.begin(), around.end(), [&](int body) {
      return !world.materials[world.bodies[body].material].glass &&
             !std::binary_search(around_eye.begin(), around_eye.end(), body);
    });
  };
  std::vector<scene::Light> reaching;
  std::copy_if(world.lights.begin(), world.lights.end(), std::back_inserter(reaching),
               [&](const scene::Light& light) { return light.color != core::black && !is_shut_in(light); });
  return reaching;
}

} // namespace halftone::shadow
