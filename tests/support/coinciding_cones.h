#pragma once
// Solids whose faces have been given the surfaces of others: beside a sphere of 1e17 whatever is parallel
// coincides, flat cones up to 2^-10 of a right angle too. Such faces may contradict each other.

#include <halftone/scene/world.h>

#include <cmath>
#include <random>

namespace halftone::test {

inline scene::World coinciding_cones(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  scene::Scene built;
  built.camera.target = {0, 1, 0};
  built.materials.push_back({});
  const auto add = [&](const scene::Shape& shape) {
    built.objects.emplace_back();
    built.objects.back().shape = shape;
  };
  add(scene::Sphere{{0, 0, 0}, 1e17});
  for (int k = 0; k < 40; ++k) {
    const core::Vec3 base{uniform(random), uniform(random), uniform(random)};
    const core::Vec3 axis{uniform(random) * 0x1p-11, uniform(random) * 0x1p-11, 1};
    const double height = std::exp2(-12 * std::abs(uniform(random)));
    add(scene::Frustum{base, base + axis * height, k % 2 == 0 ? 1.0 : 0.0, k % 2 == 0 ? 0.0 : 1.0});
    add(scene::Prism{base, base + axis * height, 1, 3 + k % 4, 0});
  }
  return scene::make_world(built);
}

} // namespace halftone::test
