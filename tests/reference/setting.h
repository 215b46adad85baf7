#pragma once
// Scenes in a few words, and the radiance that one ray brings.

#include <halftone/reference/reference.h>

#include <initializer_list>
#include <utility>
#include <vector>

namespace setting {

using halftone::core::Color;
using halftone::core::Vec3;
namespace scene = halftone::scene;

inline scene::Material matte(const Color& diffuse) {
  scene::Material material;
  material.diffuse = diffuse;
  return material;
}

inline scene::Material glass(double ior, const Color& absorption = Color{0}) {
  scene::Material material;
  material.diffuse = Color{0};
  material.glass = scene::Glass{ior, absorption};
  return material;
}

inline scene::Material mirror(const Color& reflectance) {
  scene::Material material;
  material.diffuse = Color{0};
  material.mirror = reflectance;
  return material;
}

struct Part {
  scene::Shape shape;
  scene::Material material;
};

/// Each part has a material of its own. No lights, white background, a deep tree without cut-off.
inline scene::Scene of(std::vector<Part> parts) {
  scene::Scene result;
  result.background = Color{1};
  result.camera.eye = {0, 0, 10};
  result.camera.target = {0, 0, 0};
  result.camera.up = {0, 1, 0};
  result.trace.depth = 24;
  result.trace.cutoff = 0;
  for (Part& part : parts) {
    scene::Object object;
    object.shape = std::move(part.shape);
    object.material = static_cast<int>(result.materials.size());
    result.materials.push_back(std::move(part.material));
    result.objects.push_back(std::move(object));
  }
  return result;
}

inline scene::Polygon square_at(double z, double half = 100) {
  return {{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}};
}

/// Radiance along a ray from the eye towards a point (not scaled: the camera is turned to look there).
inline Color seen(scene::Scene looked_at, const Vec3& eye, const Vec3& target) {
  looked_at.camera.eye = eye;
  looked_at.camera.target = target;
  const Vec3 along = target - eye;
  looked_at.camera.up = along.x == 0 && along.z == 0 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const scene::World world = scene::make_world(looked_at);
  halftone::reference::Counts counts;
  return halftone::reference::Reference(world).radiance(0.5 * looked_at.image.width,
                                                        0.5 * looked_at.image.height, counts);
}

/// Straight down onto the origin from z = 10.
inline Color seen_from_above(const scene::Scene& looked_at) { return seen(looked_at, {0, 0, 10}, {0, 0, 0}); }

} // namespace setting
