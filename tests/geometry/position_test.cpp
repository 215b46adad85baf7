#include "shapes.h"

#include <halftone/geometry/position.h>

#include <catch2/catch.hpp>

using namespace shapes;
using namespace halftone::geometry;

TEST_CASE("the height over a surface is negative in a quadric and behind a plane") {
  const scene::World world;
  CHECK(height_over(world, scene::Plane{{0, 0, 1}, 2}, {5, 6, 3}).value == Approx(1));
  CHECK(height_over(world, scene::Plane{{0, 0, 1}, 2}, {5, 6, -1}).value == Approx(-3));
  CHECK(height_over(world, scene::SphereSurface{{1, 0, 0}, 2}, {1, 5, 0}).value == Approx(3));
  CHECK(height_over(world, scene::SphereSurface{{1, 0, 0}, 2}, {1, 0.5, 0}).value == Approx(-1.5));
  CHECK(height_over(world, scene::ConeSurface{{0, 0, 0}, {0, 0, 1}, 1, -0.5}, {3, 0, 1}).value ==
        Approx(2.5));
  CHECK(height_over(world, scene::ConeSurface{{0, 0, 0}, {0, 0, 1}, 1, -0.5}, {0.25, 0, 1}).value ==
        Approx(-0.25));
}

TEST_CASE("a point that is calculated to lie on a surface is on it and in no solid, at any scale") {
  std::mt19937_64 random(31);
  for (const double scale : {0x1p-40, 1.0, 0x1p40}) {
    const scene::World world =
        world_of({scene::Sphere{{1, 2, 3}, 2}, scene::Box{{-5, -5, -5}, {-4, -4, -3}}}, {scale});
    for (int i = 0; i < 2'000; ++i) {
      const Vec3 direction = random_direction(random);
      const Vec3 on_sphere = (Vec3{1, 2, 3} + direction * 2.0) * scale;
      const Vec3 on_box = Vec3{-4, -4.5 + 0.4 * direction.x, -4 + 0.9 * direction.y} * scale;
      INFO("seed 31, scale " << scale << ", point " << i);
      REQUIRE(surface_under(world, on_sphere) == world.bodies[0].faces[0].surface);
      REQUIRE(surface_under(world, on_box) >= 0);
      REQUIRE(solids_around(world, on_sphere).empty());
      REQUIRE(solids_around(world, on_box).empty());
      REQUIRE(solids_around(world, (Vec3{1, 2, 3} + direction * (2 - 1e-13)) * scale) == std::vector<int>{0});
      REQUIRE(surface_under(world, (Vec3{1, 2, 3} + direction * (2 + 1e-13)) * scale) == -1);
    }
  }
}

TEST_CASE("all solids around a point are found, in ascending order") {
  const scene::World world =
      world_of({scene::Box{{-2, -2, -2}, {2, 2, 2}}, scene::Sphere{{9, 9, 9}, 1},
                scene::Frustum{{0, 0, -1}, {0, 0, 1}, 1, 0.5}, scene::Sphere{{0, 0, 0}, 0.75}});
  CHECK(solids_around(world, {0.1, 0, 0}) == std::vector<int>{0, 2, 3});
  CHECK(solids_around(world, {0, 0.9, -0.9}) == std::vector<int>{0, 2});
  CHECK(solids_around(world, {1.5, 0, 0}) == std::vector<int>{0});
  CHECK(solids_around(world, {3, 0, 0}).empty());
}
