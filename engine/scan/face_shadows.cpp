#include "face_shadows.h"

#include <halftone/core/mixed.h>

#include <algorithm>
#include <utility>

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
  const auto term = [&](const Lighting& lighting) {
    std::uint64_t casters = lighting.dark ? 1 : 0;
    for (const int caster : lighting.casters) casters += core::mixed(static_cast<std::uint64_t>(caster) + 2);
    return core::mixed(casters + static_cast<std::uint64_t>(shadow.light) * 0x9e3779b97f4a7c15);
  };
  const std::uint64_t signature = signatures_[set] - term(sets_[set][shadow.light]) + term(light);
  const auto [first, last] = by_signature_.equal_range(signature);
  for (auto same = first; same != last; ++same)
    if (sets_[same->second] == lights) return known->second = same->second;
  known->second = static_cast<int>(sets_.size());
  by_signature_.emplace(signature, known->second);
  signatures_.push_back(signature);
  sets_.push_back(std::move(lights));
  return known->second;
}

void LightSets::clear() {
  sets_.resize(1);
  signatures_.resize(1);
  by_signature_.clear();
  known_.clear();
}

FaceShadows::FaceShadows(const Frame& frame)
    : frame_(frame),
      shadows_(frame.shadows),
      of_face_(frame.faces.size()) {
  for (Shared& shared : of_face_) shared.of_light.resize(frame.world.lights.size());
}

std::vector<FaceShadow> FaceShadows::find(const ScreenFace& face, int light,
                                          std::uint64_t& comparisons) const {
  const scene::World& world = frame_.world;
  const scene::Face& own = world.bodies[face.body].faces[face.face];
  const auto& plane = std::get<scene::Plane>(world.surfaces[own.surface]);
  const auto height = [&](const core::Vec3& point) { return glm::dot(plane.normal, point) - plane.offset; };
  // A round normal may face a light that its stand-in's face does not.
  const bool in_front = (height(world.lights[light].position) > 0) == (height(world.camera.eye) > 0);
  std::vector<FaceShadow> list;
  if (!in_front && !own.rounded) return list;
  for (const shadow::Region& region : shadows_.find(face.body, face.face, light, face.outline, comparisons)) {
    const bool opaque = !world.materials[world.bodies[region.caster].material].glass;
    if (region.round)
      list.push_back({light, region.caster, opaque, false, Outline(*region.round)});
    else
      list.push_back({light, region.caster, region.dark, region.anywhere, Outline(region.outline)});
  }
  return list;
}

const FaceShadows::OnFace& FaceShadows::on(int face, std::uint64_t& comparisons) {
  Shared& shared = of_face_[face];
  const int lights = static_cast<int>(frame_.world.lights.size());
  for (int light = shared.claimed++; light < lights; light = shared.claimed++) {
    try {
      shared.of_light[light] = find(frame_.faces[face], light, comparisons);
    } catch (...) {
      const std::lock_guard lock(shared.failing);
      if (!shared.failure) shared.failure = std::current_exception();
    }
    ++shared.found; // failed or not: others wait for it
    shared.found.notify_all();
  }
  for (int found = shared.found; found < lights; found = shared.found) shared.found.wait(found);
  if (shared.failure) std::rethrow_exception(shared.failure);
  std::call_once(shared.joined, [&] {
    OnFace joined;
    for (const std::vector<FaceShadow>& list : shared.of_light)
      joined.all.insert(joined.all.end(), list.begin(), list.end());
    std::vector<geometry::Bounds> bounds;
    for (const FaceShadow& shadow : joined.all) bounds.push_back(row_bounds(shadow.outline));
    joined.rows = geometry::BoundsTree(bounds);
    shared.on_face = std::move(joined);
    shared.of_light.clear();
  });
  return shared.on_face;
}

} // namespace halftone::scan
