#pragma once
// Seeded random scenes: a floor, and convex things of all shapes and materials that touch, overlap and hide
// each other.

#include <halftone/scene/world.h>

#include <random>
#include <vector>

namespace halftone::test {

using core::Color;
using core::Vec3;

struct Wanted {
  int objects = 8;
  bool round = true;  ///< spheres, cylinders, cones, frusta
  bool glass = true;  ///< and mirrors
  bool never = false; ///< round shapes are drawn as stand-ins
  bool close = false; ///< a light is beside, on or inside the last object
};

class RandomScene {
public:
  explicit RandomScene(std::uint64_t seed) : random_(seed) {}

  scene::Scene make(const Wanted& wanted) {
    scene::Scene built;
    built.image.width = 64;
    built.image.height = 48;
    const double around = uniform(0, 6.28);
    built.camera.eye = {7 * std::cos(around), 7 * std::sin(around), uniform(0.5, 6)};
    built.camera.target = {uniform(-1, 1), uniform(-1, 1), uniform(0, 1.5)};
    built.camera.fov = uniform(20, 70);
    built.background = {0.3, 0.4, 0.6};
    built.ambient = Color{0.2};
    for (int i = 0; i < 2; ++i)
      built.lights.push_back({{uniform(-7, 7), uniform(-7, 7), uniform(0.5, 8)}, Color{uniform(0.2, 0.7)}});
    add_materials(built);
    scene::Object floor;
    floor.shape = scene::Polygon{{{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}}};
    floor.material = 1;
    built.objects.push_back(floor);
    for (int i = 0; i < wanted.objects; ++i) built.objects.push_back(object(wanted));
    if (wanted.close && wanted.objects > 0)
      built.lights[0].position = built.objects.back().placement.translate +
                                 Vec3{uniform(-1.2, 1.2), uniform(-1.2, 1.2), uniform(0.05, 1.5)};
    return built;
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

private:
  void add_materials(scene::Scene& built) {
    built.materials.resize(7);
    built.materials[1].checker = scene::Checker{{0.2, 0.3, 0.4}, uniform(0.4, 1.5), 0, 1};
    for (int i = 2; i < 5; ++i) {
      built.materials[i].diffuse = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
      built.materials[i].specular = Color{0.3};
      built.materials[i].shininess = uniform(5, 60);
    }
    built.materials[5].mirror = Color{0.7};
    built.materials[6].glass = scene::Glass{uniform(1.2, 1.8), {0.1, 0.2, 0.3}};
    built.materials[6].diffuse = Color{0};
  }

  /// Half of the objects stand on the floor without a turn.
  scene::Object object(const Wanted& wanted) {
    scene::Object made;
    const double size = uniform(0.2, 1.1), height = uniform(0.1, 2);
    const int kind = pick(wanted.round ? 7 : 3);
    switch (kind) {
    case 0:
      made.shape = scene::Box{{-size, -size * uniform(0.1, 1), 0}, {size, size, height}};
      break;
    case 1:
      made.shape = scene::Prism{{0, 0, 0}, {0, 0, height}, size, 3 + pick(6), uniform(0, 90)};
      break;
    case 2:
      made.shape = scene::Polygon{{{-size, 0, 0}, {size, 0, 0}, {size, 0, height}, {0, 0, height + size}}};
      break;
    case 3:
      made.shape = scene::Sphere{{0, 0, size}, size};
      break;
    case 4:
      made.shape = scene::Frustum{{0, 0, 0}, {0, 0, height}, size, size};
      break;
    case 5:
      made.shape = scene::Frustum{{0, 0, 0}, {0, 0, height}, size, 0};
      break;
    default:
      made.shape = scene::Frustum{{0, 0, 0}, {0, 0, height}, size, size * uniform(0.2, 1.5)};
      break;
    }
    made.material = 2 + pick(3);
    const bool round = kind > 2;
    if (round && wanted.never)
      made.trace = scene::TraceRule::never;
    else if (wanted.glass && kind != 2 && pick(2) == 0)
      made.material = 5 + pick(2);
    made.placement.translate = {uniform(-2.5, 2.5), uniform(-2.5, 2.5), 0};
    if (pick(2) == 0) {
      made.placement.rotate = {uniform(-90, 90), uniform(-90, 90), uniform(-180, 180)};
      made.placement.translate.z = uniform(0, 2);
    }
    return made;
  }

  std::mt19937_64 random_;
};

} // namespace halftone::test
