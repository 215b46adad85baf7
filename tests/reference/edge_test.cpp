#include "setting.h"

#include <halftone/shade/fresnel.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

// A ray that meets several surfaces in one point, and an eye that lies on several.

using namespace setting;
using halftone::shade::fresnel_reflectance;

namespace {

/// A square in the plane x = 0 about the origin.
scene::Polygon upright_square() { return {{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}}; }

/// From (10, 0, 10) to the origin: the planes x = 0 and z = 0 are met at the same distance, to the bit.
Color seen_on_the_diagonal(const scene::Scene& built) { return seen(built, {10, 0, 10}, {0, 0, 0}); }

scene::Material tinted(double ior) {
  scene::Material material = glass(ior);
  material.diffuse = Color{0.5};
  return material;
}

} // namespace

TEST_CASE("an opaque surface is met before a glass solid that begins at the same distance") {
  // Met last, it would be seen through the glass, with less of its light and the local term of the glass.
  scene::Scene built =
      of({{scene::Box{{-5, -5, -5}, {5, 5, 0}}, tinted(1.5)}, {upright_square(), matte({0.25, 0.5, 0.75})}});
  built.ambient = Color{1};
  CHECK(seen_on_the_diagonal(built) == Color{0.25, 0.5, 0.75});
}

TEST_CASE("a glass solid is left before an opaque surface that is met at the same distance") {
  // The eye is in the glass, which ends at x = 0. To leave it costs a level of depth, so nothing is seen.
  scene::Scene built =
      of({{scene::Box{{0, -20, -20}, {20, 20, 20}}, glass(1.2)}, {square_at(0), matte(Color{1})}});
  built.ambient = Color{1};
  built.trace.depth = 1;
  CHECK(seen_on_the_diagonal(built) == Color{0});
}

TEST_CASE("a glass solid is left before another that begins at the same distance") {
  // Entered first, the other would show its local term.
  scene::Scene built = of({{scene::Box{{0, -20, -20}, {20, 20, 20}}, glass(1.2)},
                           {scene::Box{{-5, -5, -5}, {5, 5, 0}}, tinted(1.5)}});
  built.ambient = Color{1};
  built.trace.depth = 1;
  CHECK(seen_on_the_diagonal(built) == Color{0});
}

TEST_CASE("an eye on an edge or a corner of a glass block sees what one a little off one of its faces sees") {
  scene::Scene built = of({{scene::Box{{-1, -1, -1}, {1, 1, 1}}, glass(1.5, {0.3, 0.2, 0.1})},
                           {square_at(-4), matte({0.5, 0.6, 0.7})}});
  built.ambient = {0.3, 0.4, 0.5};
  built.materials[0].diffuse = Color{0.5};
  built.trace.depth = 6;
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> component(-1, 1);
  for (const Vec3& eye : {Vec3{1, 0.25, 1}, Vec3{-1, -1, 0.5}, Vec3{1, 1, 1}, Vec3{-1, 1, -1}}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 along{component(random), component(random), component(random)};
      const Color on = seen(built, eye, eye + along);
      double least = 1;
      for (int axis = 0; axis < 3; ++axis) {
        // Off all faces that the eye lies on, farthest off the one that an entering ray then meets last.
        Vec3 off{std::trunc(eye.x), std::trunc(eye.y), std::trunc(eye.z)};
        if (off[axis] == 0) continue;
        off *= 1e-12;
        off[axis] *= 1e4;
        const Color color = seen(built, eye + off, eye + off + along);
        least = std::min(least, halftone::core::max_component(glm::abs(on - color)));
      }
      INFO("seed 31, ray " << i << ": eye " << eye.x << ' ' << eye.y << ' ' << eye.z << ", along " << along.x
                           << ' ' << along.y << ' ' << along.z);
      CHECK(least < 1e-5);
    }
  }
}

TEST_CASE("an eye just inside the corner of a glass block is in it, one on the corner is not") {
  scene::Scene built = of({{scene::Box{{-1, -1, -1}, {1, 1, 1}}, glass(1.5, Color{0.5})}});
  const double r = fresnel_reflectance(1, 1, 1.5), in = 1 - 1e-9;
  // From inside straight down to the floor, 2 below: one boundary at depth 2. From the corner: the lid first.
  built.trace.depth = 2;
  CHECK(seen(built, {in, in, in}, {in, in, 0}).r == Approx((1 - r) * std::exp(-1)));
  CHECK(seen(built, {in, in, 1}, {in, in, 0}).r == Approx(r));
  // Outward, the corner is left without a boundary.
  CHECK(seen(built, {1, 1, 1}, {1.25, 1.5, 2}) == Color{1});
  built.trace.depth = 1;
  CHECK(seen(built, {in, in, in}, {1.25, 1.5, 2}) == Color{0});
}

TEST_CASE("an eye on an edge of a turned glass block sees nothing of it beside either face") {
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> angle(-180, 180), part(-0.9, 0.9);
  int different = 0;
  for (int i = 0; i < 300; ++i) {
    scene::Scene built = of({{scene::Box{{-1, -1, -1}, {1, 1, 1}}, tinted(1.5)}});
    built.ambient = Color{1};
    const double degrees = angle(random), radians = degrees * std::acos(-1.0) / 180;
    built.objects[0].placement.rotate = {0, 0, degrees};
    const auto turned = [&](const Vec3& p) {
      return Vec3{std::cos(radians) * p.x - std::sin(radians) * p.y,
                  std::sin(radians) * p.x + std::cos(radians) * p.y, p.z};
    };
    const Vec3 eye = turned({1, 1, part(random)});
    // Into the half-space of one face, out of the other's.
    if (seen(built, eye, eye + turned({-1, 0.25, 0.5})) != Color{1}) ++different;
    if (seen(built, eye, eye + turned({0.25, -1, 0.5})) != Color{1}) ++different;
  }
  CHECK(different == 0);
}
