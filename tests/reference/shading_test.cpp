#include "setting.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace setting;

TEST_CASE("a ray that hits nothing brings the background") {
  scene::Scene empty = of({});
  empty.background = {0.1, 0.2, 0.3};
  CHECK(seen_from_above(empty) == Color{0.1, 0.2, 0.3});
}

TEST_CASE("a lit floor has its ambient and diffuse terms") {
  scene::Scene lit = of({{square_at(0), matte({0.5, 0.25, 1})}});
  lit.ambient = {0.1, 0.2, 0.3};
  lit.lights.push_back({{3, 0, 4}, {1, 2, 0.5}}); // n . l = 0.8
  const Color color = seen_from_above(lit);
  CHECK(color.r == Approx(0.5 * (0.1 + 0.8)));
  CHECK(color.g == Approx(0.25 * (0.2 + 1.6)));
  CHECK(color.b == Approx(0.3 + 0.4));
}

TEST_CASE("two facing mirrors are seen to the depth of the tree") {
  scene::Scene room = of({{square_at(0), mirror(Color{0.5})}, {square_at(20), mirror(Color{0.5})}});
  for (scene::Material& material : room.materials) material.diffuse = Color{1};
  room.ambient = Color{1};
  double expected = 0;
  for (int depth = 1; depth <= 6; ++depth) {
    expected += std::pow(0.5, depth - 1);
    room.trace.depth = depth;
    CHECK(seen_from_above(room).g == Approx(expected));
  }
  room.trace.depth = 24;
  room.trace.cutoff = 0.2; // 0.5 and 0.25 are followed, 0.125 is not
  CHECK(seen_from_above(room).g == Approx(1.75));
  room.trace.cutoff = 0.25; // not below it
  CHECK(seen_from_above(room).g == Approx(1.75));
}

TEST_CASE(
    "where opaque surfaces coincide, a polygon is seen before a solid, otherwise the last in the file") {
  const scene::Box low{{-1, -1, -1}, {1, 1, 0}}, other{{-2, -2, -2}, {2, 2, 0}};
  const Color red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};
  const auto ambient_only = [](std::vector<Part> parts) {
    scene::Scene built = of(std::move(parts));
    built.ambient = Color{1};
    return seen_from_above(built);
  };
  CHECK(ambient_only({{low, matte(red)}, {other, matte(green)}}) == green);
  CHECK(ambient_only({{other, matte(green)}, {low, matte(red)}}) == red);
  CHECK(ambient_only({{square_at(0), matte(blue)}, {low, matte(red)}, {other, matte(green)}}) == blue);
  CHECK(ambient_only({{square_at(0), matte(blue)}, {square_at(0), matte(red)}}) == red);
}

TEST_CASE("inside an opaque solid the eye sees its inner walls, also where a polygon touches from outside") {
  scene::Scene room =
      of({{scene::Box{{-1, -1, 0}, {1, 1, 20}}, matte({1, 0, 0})}, {square_at(0), matte({0, 0, 1})}});
  room.ambient = Color{1};
  CHECK(seen_from_above(room) == Color{1, 0, 0});
  // A light inside lights the walls and nothing outside.
  room.ambient = Color{0};
  room.lights.push_back({{0, 0, 5}, {1, 1, 1}});
  CHECK(seen_from_above(room).r == Approx(1));
  CHECK(seen(room, {5, 0, 10}, {5, 0, 0}) == Color{0});
}

TEST_CASE("a stand-in is shaded on its sides with the round surface's normal, on its caps flat") {
  scene::Scene built = of({{scene::Frustum{{0, 0, 0}, {0, 0, 2}, 1, 1}, matte(Color{1})}});
  built.objects[0].trace = scene::TraceRule::never;
  built.trace.facets = 6;
  built.lights.push_back({{100, 0, 1}, Color{1}});
  // Facet 0 spans azimuths 0 to 60 degrees; a ray along its normal hits its middle, azimuth 30, and others
  // around.
  for (const double azimuth : {5.0, 20.0, 30.0, 55.0}) {
    const double phi = azimuth * std::acos(-1.0) / 180;
    const double facet_distance = std::cos(std::acos(-1.0) / 6) / std::cos(phi - std::acos(-1.0) / 6);
    const Vec3 hit{facet_distance * std::cos(phi), facet_distance * std::sin(phi), 1};
    const Vec3 to_light = glm::normalize(built.lights[0].position - hit);
    const Color color = seen(built, hit * 10.0 - Vec3{0, 0, 9}, hit);
    INFO("azimuth " << azimuth);
    CHECK(color.r == Approx(glm::dot(Vec3{std::cos(phi), std::sin(phi), 0}, to_light)));
  }
  built.lights[0].position = {0, 0, 50};
  CHECK(seen_from_above(built).r == Approx(1));
}

TEST_CASE("the rounded normal of a stand-in is turned to face the ray") {
  const double degree = std::acos(-1.0) / 180;
  const auto around = [&](double azimuth) {
    return Vec3{std::cos(azimuth * degree), std::sin(azimuth * degree), 0};
  };
  scene::Scene built = of({{scene::Frustum{{0, 0, -1}, {0, 0, 1}, 1, 1}, matte(Color{1})}});
  built.objects[0].trace = scene::TraceRule::never;
  built.trace.facets = 6;
  // From the axis, by a light there: the normal points back along both.
  built.lights.push_back({{0, 0, 0}, Color{1}});
  CHECK(seen(built, {0, 0, 0}, around(55)).r == Approx(1));
  // Facet 0 looks to azimuth 30. From azimuth -45 its point at azimuth 55 is seen, whose round normal is
  // turned away from there by 100 degrees; turned to the ray it looks to -125, 25 degrees from the light.
  const Vec3 hit = around(55) * (std::cos(30 * degree) / std::cos(25 * degree));
  built.lights[0].position = hit + around(-100) * 1e6;
  CHECK(seen(built, hit + around(-45) * 5.0, hit).r == Approx(std::cos(25 * degree)));
}

TEST_CASE("a pattern that changes in a polygon's plane shows either side the cell behind it") {
  scene::Material layered = matte({1, 0, 0});
  layered.checker = scene::Checker{{0, 1, 0}, 1, 0, 2};
  scene::Scene built = of({{square_at(0), layered}});
  built.ambient = Color{1};
  CHECK(seen(built, {0.5, 0, 10}, {0.5, 0, 0}) == Color{0, 1, 0});  // cells 0 and -1
  CHECK(seen(built, {0.5, 0, -10}, {0.5, 0, 0}) == Color{1, 0, 0}); // cells 0 and 0
}

TEST_CASE("the radiance of every ray is the same to the bit when the scene is scaled by powers of two") {
  const auto scaled = [](double s) {
    scene::Material floor = matte({0.8, 0.6, 0.4});
    floor.checker = scene::Checker{{0.1, 0.2, 0.3}, 0.7 * s, 0, 1};
    scene::Material clear = glass(1.5, Color{0.3, 0.2, 0.1} / s);
    clear.specular = {0.5, 0.5, 0.5};
    scene::Scene built =
        of({{scene::Polygon{{Vec3{-8, -8, 0} * s, Vec3{8, -8, 0} * s, Vec3{8, 8, 0} * s, Vec3{-8, 8, 0} * s}},
             floor},
            {scene::Prism{{0, 0, 0}, Vec3{0, 0, 0.8} * s, 1.9 * s, 8, 22.5}, clear},
            {scene::Frustum{Vec3{0, 0, 0.8} * s, Vec3{0, 0, 2.5} * s, 0.7 * s, 0.4 * s}, clear},
            {scene::Sphere{Vec3{2, 1, 0.5} * s, 0.5 * s}, mirror({0.9, 0.8, 0.7})}});
    built.ambient = Color{0.2};
    built.lights.push_back({Vec3{-5, -6, 9} * s, Color{1}});
    built.camera.eye = Vec3{4.2, -6.4, 4.6} * s;
    built.camera.target = Vec3{0, 0, 0.95} * s;
    built.camera.up = {0, 0, 1};
    return scene::make_world(built);
  };
  const scene::World middle = scaled(1), large = scaled(0x1p40), small = scaled(0x1p-40);
  const halftone::reference::Reference at_middle(middle), at_large(large), at_small(small);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> pixel(0, 512);
  for (int i = 0; i < 3'000; ++i) {
    const double x = pixel(random), y = pixel(random);
    halftone::reference::Counts counts;
    const Color color = at_middle.radiance(x, y, counts);
    INFO("seed 11, ray " << i << " at " << x << ", " << y);
    REQUIRE(at_large.radiance(x, y, counts) == color);
    REQUIRE(at_small.radiance(x, y, counts) == color);
  }
}
