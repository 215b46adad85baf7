#include "setting.h"

#include <halftone/shade/fresnel.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace setting;
using halftone::shade::fresnel_reflectance;

namespace {

/// What a light straight above at z = 8 leaves on a white floor at the origin, seen from the side.
Color lit_floor(std::vector<Part> above) {
  std::vector<Part> parts{{square_at(0), matte(Color{1})}};
  for (Part& part : above) parts.push_back(std::move(part));
  scene::Scene built = of(std::move(parts));
  built.lights.push_back({{0, 0, 8}, Color{1}});
  return seen(built, {5, 0, 1}, {0, 0, 0});
}

} // namespace

TEST_CASE("an opaque surface between light and point makes it dark") {
  CHECK(lit_floor({}).r == Approx(1));
  CHECK(lit_floor({{scene::Sphere{{0, 0, 4}, 1}, matte(Color{1})}}) == Color{0});
  CHECK(lit_floor({{square_at(4, 1), matte(Color{1})}}) == Color{0});
  CHECK(lit_floor({{scene::Sphere{{2, 0, 4}, 1}, matte(Color{1})}}).r == Approx(1));
  CHECK(lit_floor({{scene::Sphere{{0, 0, 12}, 1}, matte(Color{1})}}).r == Approx(1)); // behind the light
}

TEST_CASE("glass lets through (1-ra)(1-rb) and what it does not absorb") {
  const double r = fresnel_reflectance(1, 1, 1.5);
  const Color color = lit_floor({{scene::Box{{-1, -1, 3}, {1, 1, 5}}, glass(1.5, {0.5, 0.1, 0})}});
  CHECK(color.r == Approx((1 - r) * (1 - r) * std::exp(-1)));
  CHECK(color.g == Approx((1 - r) * (1 - r) * std::exp(-0.2)));
  CHECK(color.b == Approx((1 - r) * (1 - r)));
}

TEST_CASE("nested and touching glass shadows by the medium that changes") {
  const double outer = fresnel_reflectance(1, 1, 1.5), inner = fresnel_reflectance(1, 1.5, 1.2);
  const scene::Box block{{-1, -1, 3}, {1, 1, 6}};
  const scene::Box core{{-0.5, -0.5, 4}, {0.5, 0.5, 5}};
  CHECK(lit_floor({{block, glass(1.5, {1, 0, 0})}, {core, glass(1.2, {0, 1, 0})}}).r ==
        Approx(std::pow(1 - outer, 2) * std::pow(1 - inner, 2) * std::exp(-2)));
  CHECK(lit_floor({{core, glass(1.2)}, {block, glass(1.5, {1, 0, 0})}}).r ==
        Approx(std::pow(1 - outer, 2) * std::exp(-3)));
  // A second block on top of the first: the gap between them has two boundaries.
  CHECK(lit_floor({{block, glass(1.5)}, {scene::Box{{-1, -1, 6}, {1, 1, 7}}, glass(1.5)}}).r ==
        Approx(std::pow(1 - outer, 4)));
}

TEST_CASE("a point under a touching glass solid sees the light through both of its walls") {
  const double r = fresnel_reflectance(1, 1, 1.5);
  // The eye is inside the block, so the floor is seen through its lower wall.
  scene::Scene built =
      of({{square_at(0), matte(Color{1})}, {scene::Box{{-1, -1, 0}, {1, 1, 2}}, glass(1.5)}});
  built.lights.push_back({{0, 0, 8}, Color{1}});
  built.trace.depth = 2;
  CHECK(seen(built, {0, 0, 1}, {0, 0, 0}).r == Approx(std::pow(1 - r, 3)));
}

TEST_CASE("where the light's straight path is totally reflected, nothing passes") {
  // A thin upright plate, met by the light at a grazing angle, passes; a wedge that it leaves beyond the
  // critical angle does not.
  const scene::Polyhedron wedge{{{-1, -1, 3}, {1, -1, 3}, {-1, 1, 3}, {1, 1, 3}, {-1, -1, 6}, {-1, 1, 6}},
                                {{0, 2, 3, 1}, {0, 4, 5, 2}, {1, 3, 5, 4}, {0, 1, 4}, {2, 5, 3}}};
  CHECK(lit_floor({{wedge, glass(1.5)}}).r > 0.5); // enters by the slope, at 56 degrees, leaves straight
  scene::Polyhedron turned = wedge;
  for (Vec3& v : turned.vertices) v.z = 9 - v.z; // enters straight, leaves by the slope: sin 56 > 1 / 1.5
  CHECK(lit_floor({{turned, glass(1.5)}}) == Color{0});
}

TEST_CASE("an opaque block on the floor shadows beside it, up to its edge, and not itself") {
  scene::Scene built =
      of({{square_at(0), matte(Color{1})}, {scene::Box{{-1, -1, 0}, {1, 1, 2}}, matte(Color{1})}});
  built.lights.push_back(
      {{-4, 0, 5}, Color{1}}); // over the box's top edge at x = 1: shadow to x = 1 + 10 / 3
  for (const double x : {1 + 1e-9, 1.5, 4.3333}) CHECK(seen(built, {x, 0, 10}, {x, 0, 0}) == Color{0});
  CHECK(seen(built, {4.3334, 0, 10}, {4.3334, 0, 0}).r > 0);
  CHECK(seen(built, {-1 - 1e-9, 0, 10}, {-1 - 1e-9, 0, 0}).r > 0);
  CHECK(seen(built, {0, 0, 10}, {0, 0, 2}).r > 0);  // the lid
  CHECK(seen(built, {-9, 0, 1}, {-1, 0, 1}).r > 0); // the lit side
  CHECK(seen(built, {9, 0, 1}, {1, 0, 1}) == Color{0});
}

TEST_CASE(
    "a light inside glass reaches the outside through the wall, and one on a surface counts as outside") {
  const double r = fresnel_reflectance(1, 1, 1.5);
  scene::Scene built =
      of({{square_at(0), matte(Color{1})}, {scene::Sphere{{0, 0, 4}, 1}, glass(1.5, Color{1})}});
  built.lights.push_back({{0, 0, 4}, Color{1}});
  CHECK(seen(built, {9, 0, 3}, {0, 0, 0}).r == Approx((1 - r) * std::exp(-1)));
  built.lights[0].position = {0, 0, 3}; // at the lowest point
  CHECK(seen(built, {9, 0, 3}, {0, 0, 0}).r == Approx(1));
  built.lights[0].position = {0, 0, 5}; // at the highest point: through all of it
  CHECK(seen(built, {9, 0, 3}, {0, 0, 0}).r == Approx((1 - r) * (1 - r) * std::exp(-2)));
}

TEST_CASE("a light on a polygon is not shadowed by it") {
  const std::vector<Part> lamp{{square_at(8, 3), matte(Color{1})}};
  CHECK(lit_floor(lamp).r == Approx(1));
}
