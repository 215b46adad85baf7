#pragma once
// Shapes, worlds of them, and random directions.

#include <halftone/scene/world.h>

#include <random>
#include <vector>

namespace shapes {

using halftone::core::Vec3;
namespace scene = halftone::scene;

/// About 3 in size, near the origin.
inline std::vector<scene::Shape> one_of_each() {
  return {scene::Sphere{{1, 2, 3}, 2},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 1.5, 1.5},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 1.5, 0},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 0, 1.5},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 0.5, 2},
          scene::Frustum{{0, 0, 0}, {0.1, 0, 0}, 3, 1},
          scene::Box{{-1, -2, -0.5}, {2, 1, 0.25}},
          scene::Prism{{0, 0, -1}, {0, 1, 2}, 1.25, 7, 11}};
}

inline scene::World world_of(const std::vector<scene::Shape>& shapes,
                             const scene::Placement& placement = {}) {
  scene::Scene built;
  built.camera.target = {1, 0, 0};
  built.materials.push_back({});
  for (const scene::Shape& shape : shapes) {
    scene::Object object;
    object.shape = shape;
    object.placement = placement;
    built.objects.push_back(object);
  }
  return scene::make_world(built);
}

inline Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return glm::normalize(Vec3{x, y, z});
}

inline Vec3 random_point(std::mt19937_64& random, double half) {
  std::uniform_real_distribution<double> uniform(-half, half);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

} // namespace shapes
