#pragma once
// What keeps a scene of a fuzzer small: a thousand of two things are slower than two and show nothing more.

#include <halftone/scene/scene.h>

#include <algorithm>

namespace halftone::fuzz {

inline void make_small(scene::Scene& scene) {
  scene.image.width = std::min(scene.image.width, 8);
  scene.image.height = std::min(scene.image.height, 6);
  scene.trace.depth = std::min(scene.trace.depth, 4);
  scene.trace.facets = std::min(scene.trace.facets, 12);
  scene.lights.resize(std::min<std::size_t>(scene.lights.size(), 3));
  scene.objects.resize(std::min<std::size_t>(scene.objects.size(), 8));
  for (scene::Object& object : scene.objects)
    if (auto* prism = std::get_if<scene::Prism>(&object.shape)) prism->sides = std::min(prism->sides, 12);
}

} // namespace halftone::fuzz
