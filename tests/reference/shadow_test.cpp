#include "setting.h"

#include <halftone/shade/fresnel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <utility>

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

TEST_CASE("a light on a polygon is not shadowed by it, whatever rounding says") {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> tilt(-0.7, 0.7);
  for (int i = 0; i < 100; ++i) {
    const double a = tilt(random), b = tilt(random); // z = 8 + a x + b y
    const scene::Polygon lamp{{{-3, -3, 8 - 3 * a - 3 * b},
                               {3, -3, 8 + 3 * a - 3 * b},
                               {3, 3, 8 + 3 * a + 3 * b},
                               {-3, 3, 8 - 3 * a + 3 * b}}};
    INFO("seed 41, polygon " << i << " of slopes " << a << ", " << b);
    CHECK(lit_floor({{lamp, matte(Color{1})}}).r == Approx(1));
  }
}

TEST_CASE(
    "a light on an opaque ball lights what lies before it, and nothing behind, whatever rounding says") {
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> component(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 out = glm::normalize(Vec3{component(random) / 2, component(random) / 2, -1});
    scene::Scene built =
        of({{square_at(0), matte(Color{1})}, {scene::Sphere{{0, 0, 4}, 1}, matte(Color{1})}});
    INFO("seed 42, light " << i << " to " << out.x << ' ' << out.y << ' ' << out.z);
    for (const double side : {1.0, -1.0}) {
      built.lights = {{Vec3{0, 0, 4} + out * side, Color{1}}};
      const Vec3 below{built.lights[0].position.x, built.lights[0].position.y, 0};
      const Color color = seen(built, {5, 0, 1}, below);
      CHECK(color.r == (side > 0 ? Approx(1) : Approx(0)));
    }
  }
}

TEST_CASE("a point inside absorbing glass gets the light that the glass leaves on its way there") {
  const double r = fresnel_reflectance(1, 1, 1.5);
  scene::Scene built = of({{scene::Box{{-2, -2, -2}, {2, 2, 2}}, glass(1.5, {0.5, 0.1, 0})},
                           {scene::Box{{-1, -1, -1}, {1, 1, 0}}, matte(Color{1})}});
  // 2 in the glass from its lid to the point, then 1 to the eye, which is in the glass.
  built.lights.push_back({{0, 0, 8}, Color{1}});
  const Color from_outside = seen(built, {0, 0, 1}, {0, 0, 0});
  CHECK(from_outside.r == Approx((1 - r) * std::exp(-0.5 * 3)));
  CHECK(from_outside.g == Approx((1 - r) * std::exp(-0.1 * 3)));
  CHECK(from_outside.b == Approx(1 - r));
  // No boundary at all from a light 1.5 above the point.
  built.lights[0].position = {0, 0, 1.5};
  CHECK(seen(built, {0, 0, 1}, {0, 0, 0}).r == Approx(std::exp(-0.5 * 2.5)));
}

TEST_CASE("inside two opaque solids with a common floor, neither shadows it") {
  scene::Scene room = of({{scene::Box{{-1, -1, 0}, {1, 1, 20}}, matte(Color{1})},
                          {scene::Box{{-2, -2, 0}, {2, 2, 20}}, matte(Color{1})}});
  room.lights.push_back({{0, 0, 5}, Color{1}});
  CHECK(seen_from_above(room).r == Approx(1));
  std::swap(room.objects[0], room.objects[1]);
  CHECK(seen_from_above(room).r == Approx(1));
}

TEST_CASE("the walls of an opaque room are lit from inside up to their edges, whatever rounding says") {
  scene::Scene room = of({{scene::Box{{-1, -1, -1}, {1, 1, 1}}, matte(Color{1})}});
  room.objects[0].placement = {0.7, {20, 50, 80}, {0.1, 0.2, 0.3}};
  const scene::World world = scene::make_world(room);
  std::vector<Vec3> corners;
  for (const scene::Face& face : world.bodies[0].faces)
    corners.insert(corners.end(), face.outline.begin(), face.outline.end());
  room.lights.push_back({{0.2, 0.3, 0.4}, Color{1}});
  std::mt19937_64 random(43);
  std::uniform_real_distribution<double> part(0, 1);
  for (std::size_t i = 0; i < corners.size(); ++i) { // four corners a face
    const Vec3 next = i % 4 == 3 ? corners[i - 3] : corners[i + 1];
    for (int k = 0; k < 20; ++k) {
      INFO("seed 43, edge " << i << ", ray " << k);
      CHECK(seen(room, {0.1, 0.15, 0.2}, glm::mix(corners[i], next, part(random))).r > 0);
    }
  }
}

TEST_CASE("a stand-in does not shadow its own facets, where they turn away from the light that they show") {
  const double degree = std::acos(-1.0) / 180;
  const auto around = [&](double azimuth) {
    return Vec3{std::cos(azimuth * degree), std::sin(azimuth * degree), 0};
  };
  scene::Scene built = of({{scene::Frustum{{0, 0, -1}, {0, 0, 1}, 1, 1}, matte(Color{1})}});
  built.objects[0].trace = scene::TraceRule::never;
  built.trace.facets = 6;
  // Facet 0 looks to azimuth 30, its point at azimuth 55 is shaded as if it looked there; the light stands at
  // 130, behind the facet and before the round normal.
  const Vec3 hit = around(55) * (std::cos(30 * degree) / std::cos(25 * degree));
  built.lights.push_back({hit + around(130) * 1e6, Color{1}});
  CHECK(seen(built, hit + around(40) * 5.0, hit).r == Approx(std::cos(75 * degree)));
  // Another's facets are shadowed.
  built.objects.push_back(built.objects[0]);
  built.objects[1].shape = scene::Sphere{hit + around(130) * 4.0, 1};
  built.objects[1].trace = scene::TraceRule::automatic;
  CHECK(seen(built, hit + around(40) * 5.0, hit) == Color{0});
}
