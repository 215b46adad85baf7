#include "face_shadows.h"

#include <algorithm>

namespace halftone::scan {

int LightSets::with(int set, const FaceShadow& shadow) {
  if (sets_[set][shadow.light].dark) return set;
  const auto [known, is_new] = known_.try_emplace({set, shadow.light, shadow.caster, shadow.dark}, 0);
  if (!is_new) return known->second;
  std::vector<Lighting> lights = sets_[set];
  Lighting& light = lights[shadow.light];
  if (shadow.dark) {
    light = {true, {}};
  } else {
    const auto place = std::lower_bound(light.casters.begin(), light.casters.end(), shadow.caster);
    light.casters.insert(place, shadow.caster);
  }
  // The same may have been reached in another order.
  const auto same = std::find(sets_.begin(), sets_.end(), lights);
  known->second = static_cast<int>(same - sets_.begin());
  if (same == sets_.end()) sets_.push_back(std::move(lights));
  return known->second;
}

std::vector<FaceShadow> shadows_of(const Frame& frame, shadow::Shadows& shadows, const ScreenFace& face) {
  const scene::World& world = frame.world;
  const scene::Face& own = world.bodies[face.body].faces[face.face];
  const auto& plane = std::get<scene::Plane>(world.surfaces[own.surface]);
  const auto height = [&](const core::Vec3& point) { return glm::dot(plane.normal, point) - plane.offset; };
  std::vector<FaceShadow> list;
  for (int light = 0; light < static_cast<int>(world.lights.size()); ++light) {
    // A round normal may face a light that its stand-in's face does not.
    const bool in_front = (height(world.lights[light].position) > 0) == (height(world.camera.eye) > 0);
    if (!in_front && !own.rounded) continue;
    for (const shadow::Region& region : shadows.on(face.body, face.face, light)) {
      const bool opaque = !world.materials[world.bodies[region.caster].material].glass;
      if (region.round)
        list.push_back({light, region.caster, opaque, false, Outline(*region.round)});
      else
        list.push_back({light, region.caster, region.dark, region.anywhere, Outline(region.outline)});
    }
  }
  return list;
}

} // namespace halftone::scan
