#pragma once
// Scenes in other units and elsewhere, with all in them that has a place or a length: the picture is the
// same.

#include <halftone/scene/scene.h>

#include <variant>

namespace halftone::test {

inline void scale(scene::Sphere& s, double by) { s.center *= by, s.radius *= by; }
inline void scale(scene::Frustum& f, double by) {
  f.base *= by, f.top *= by, f.base_radius *= by, f.top_radius *= by;
}
inline void scale(scene::Box& b, double by) { b.min *= by, b.max *= by; }
inline void scale(scene::Prism& p, double by) { p.base *= by, p.top *= by, p.radius *= by; }
inline void scale(scene::Polyhedron& p, double by) {
  for (core::Vec3& v : p.vertices) v *= by;
}
inline void scale(scene::Polygon& p, double by) {
  for (core::Vec3& v : p.vertices) v *= by;
}

/// In other units. Glass absorbs as much on the way through it.
inline scene::Scene scaled(scene::Scene scene, double by) {
  scene.camera.eye *= by;
  scene.camera.target *= by;
  for (scene::Light& light : scene.lights) light.position *= by;
  for (scene::Material& material : scene.materials) {
    if (material.checker) material.checker->size *= by;
    if (material.glass) material.glass->absorption /= by;
  }
  for (scene::Object& object : scene.objects) {
    object.placement.translate *= by;
    std::visit([&](auto& shape) { scale(shape, by); }, object.shape);
  }
  return scene;
}

/// Everything's place by move(point). What an object's own numbers say is not touched, and patterns stay
/// where they are in the world.
template<typename Move>
scene::Scene moved(scene::Scene scene, const Move& move) {
  scene.camera.eye = move(scene.camera.eye);
  scene.camera.target = move(scene.camera.target);
  for (scene::Light& light : scene.lights) light.position = move(light.position);
  for (scene::Object& object : scene.objects) object.placement.translate = move(object.placement.translate);
  return scene;
}

/// A million units and more along each axis, in whole periods of the pattern, which are two cells. The scene
/// has patterns of one size, if any.
inline scene::Scene far_away(const scene::Scene& scene) {
  core::Vec3 offset{1e6, -2e6, 1.5e6};
  for (const scene::Material& material : scene.materials)
    if (material.checker) {
      const double period = 2 * material.checker->size;
      offset = period * glm::round(offset / period);
      break;
    }
  return moved(scene, [&](const core::Vec3& p) { return p + offset; });
}

} // namespace halftone::test
