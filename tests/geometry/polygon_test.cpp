#include "shapes.h"

#include <halftone/geometry/solids.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace shapes;
using halftone::geometry::Line;
using halftone::geometry::Solids;

TEST_CASE(
    "a polygon is crossed ahead, from both sides, inside its outline and not where the line starts on it") {
  const scene::World world = world_of({scene::Polygon{{{-1, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-1, 1, 0}}}});
  const Solids solids(world);
  std::mt19937_64 random(21);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 origin = random_point(random, 4), direction = random_direction(random);
    const auto crossing = solids.crossing(0, {origin, direction});
    const double t = -origin.z / direction.z;
    const Vec3 p = origin + direction * t;
    // Rounding decides within 1e-9 of an edge.
    if (std::abs(std::abs(p.y) - 1) < 1e-9 || std::abs(p.x + 1) < 1e-9 || std::abs(p.x - 2) < 1e-9) continue;
    INFO("seed 21, line " << i);
    REQUIRE(crossing.has_value() == (t > 0 && p.x > -1 && p.x < 2 && std::abs(p.y) < 1));
    if (crossing) REQUIRE(crossing->t == Approx(t));
    REQUIRE_FALSE(solids.crossing(0, {origin, direction, world.bodies[0].faces[0].surface, false}));
  }
  CHECK_FALSE(solids.crossing(0, {{0, 0, 0}, {1, 0, 0}}));
  CHECK_FALSE(solids.crossing(0, {{0, 0, 1}, {1, 0, 0}}));
}

TEST_CASE("a line through an edge that two polygons share crosses one of them") {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> share(0, 1);
  int crossed = 0;
  for (int round = 0; round < 400; ++round) {
    // Two triangles with a common edge, folded, outlines either way round.
    const Vec3 a = random_point(random, 2), b = random_point(random, 2);
    Vec3 c = random_point(random, 2), d = random_point(random, 2);
    const Vec3 side = glm::cross(b - a, Vec3{0, 0, 1});
    if (glm::dot(c - a, side) * glm::dot(d - a, side) > 0) d = a - (d - a); // on two sides, as seen along z
    const std::vector<Vec3> second = round % 2 ? std::vector<Vec3>{a, b, d} : std::vector<Vec3>{b, a, d};
    const Solids solids(world_of({scene::Polygon{{a, b, c}}, scene::Polygon{second}}));
    for (int i = 0; i < 50; ++i) {
      // From far above, so that both are seen from their upper sides and neither hides behind the other.
      const Vec3 aim = a + (b - a) * (i == 0 ? 0.5 : share(random));
      const Vec3 origin = aim + Vec3{0, 0, 40} + random_point(random, 0.01);
      const Line line{origin, glm::normalize(aim - origin)};
      INFO("seed 22, round " << round << ", line " << i);
      REQUIRE((solids.crossing(0, line) || solids.crossing(1, line)));
      ++crossed;
    }
  }
  CHECK(crossed == 20'000);
}
