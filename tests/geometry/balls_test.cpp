#include "shapes.h"

#include <halftone/geometry/balls.h>
#include <halftone/geometry/solids.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace shapes;
using namespace halftone::geometry;

namespace {

/// Points on the outline of a body: corners, and points of rims, apex and sphere.
std::vector<Vec3> extreme_points(const scene::World& world, const scene::Body& body,
                                 std::mt19937_64& random) {
  std::vector<Vec3> points;
  for (const scene::Face& face : body.faces)
    points.insert(points.end(), face.outline.begin(), face.outline.end());
  if (body.kind == scene::BodyKind::sphere) {
    const auto& sphere = std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]);
    for (int k = 0; k < 8; ++k) points.push_back(sphere.center + random_direction(random) * sphere.radius);
  }
  if (body.kind == scene::BodyKind::frustum) {
    const auto& side = std::get<scene::ConeSurface>(world.surfaces[body.faces[0].surface]);
    const Vec3 u = glm::normalize(glm::cross(side.axis, random_direction(random)));
    for (std::size_t f = 1; f < body.faces.size(); ++f) {
      const auto& disc = std::get<scene::Plane>(world.surfaces[body.faces[f].surface]);
      const double height =
          (disc.offset - glm::dot(disc.normal, side.origin)) / glm::dot(disc.normal, side.axis);
      points.push_back(side.origin + side.axis * height + u * (side.radius + side.slope * height));
    }
    if (side.slope != 0) points.push_back(side.origin - side.axis * (side.radius / side.slope));
  }
  return points;
}

/// The t at which a line first meets a body ahead of it, or infinity.
double first_meeting(const scene::World& world, const Solids& solids, int body, const Line& line) {
  if (world.bodies[body].kind == scene::BodyKind::polygon) {
    const auto crossing = solids.crossing(body, line);
    return crossing ? crossing->t : std::numeric_limits<double>::infinity();
  }
  const auto span = solids.span(body, line);
  return span ? std::max(span->in.t, 0.0) : std::numeric_limits<double>::infinity();
}

std::vector<scene::Shape> thick_and_thin() {
  std::vector<scene::Shape> all = one_of_each();
  all.push_back(scene::Box{{-3, -3, 1}, {3, 3, 1 + 1e-6}});                           // a plate
  all.push_back(scene::Box{{-3, 2, 1}, {3, 2 + 1e-7, 1 + 1e-7}});                     // a needle
  all.push_back(scene::Frustum{{0, 0, 4}, {0, 0, 4 + 1e-5}, 2, 0});                   // a flat cone
  all.push_back(scene::Frustum{{0, 0, -4}, {5, 1, -4}, 1e-6, 0});                     // a sharp one
  all.push_back(scene::Polyhedron{{{0, 0, 0}, {4, 0, 0}, {4, 1e-6, 0}, {4, 0, 1e-6}}, // a thorn
                                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
  all.push_back(scene::Polygon{{{-4, -4, 1}, {4, -4, 1}, {4, 4, 1}, {-4, 4, 1}}}); // touches the plate
  all.push_back(scene::Polygon{{{0, 0, 2}, {4, 0, 2}, {4, 1e-6, 2}}});
  return all;
}

} // namespace

TEST_CASE("no line that meets a body is turned away, however it grazes and from however far it comes") {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> angle(-180, 180), magnitude(-16, 0), far(0, 7);
  int met = 0;
  bool is_tangent = false;
  for (int round = 0; round < 200; ++round) {
    const scene::Placement turned{1, {angle(random), angle(random), angle(random)}, random_point(random, 20)};
    const scene::World world = world_of(thick_and_thin(), turned);
    const Solids solids(world);
    const Balls balls(world);
    std::vector<Near> memory;
    for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b)
      for (const Vec3& extreme : extreme_points(world, world.bodies[b], random)) {
        const Vec3 aim = extreme + random_direction(random) * std::pow(10, magnitude(random));
        // Half of the lines touch the ball where the body does.
        const Vec3 radius = extreme - bounding_ball(world, world.bodies[b]).center;
        Vec3 direction = random_direction(random);
        is_tangent = !is_tangent;
        if (is_tangent) direction = glm::normalize(glm::cross(radius, direction));
        const Line line{aim - direction * std::pow(10, far(random)), direction};
        const auto near = balls.gather(line, memory);
        const Ray ray(line.origin, line.direction);
        for (int other = 0; other < static_cast<int>(world.bodies.size()); ++other) {
          const double t = first_meeting(world, solids, other, line);
          if (!std::isfinite(t)) continue;
          ++met;
          const auto found =
              std::find_if(near.begin(), near.end(), [&](const Near& n) { return n.body == other; });
          INFO("seed 41, round " << round << ", aimed at body " << b << ", meets " << other);
          REQUIRE(balls.may_meet(other, line));
          REQUIRE(found != near.end());
          REQUIRE(found->from <= t);
          const double reach = glm::length(line.origin) + 40; // the bodies' too
          REQUIRE(ray.passes(bounding_box(world, world.bodies[other], reach), t));
        }
      }
  }
  CHECK(met > 20'000);
}

TEST_CASE("most lines that pass a body by are turned away") {
  std::mt19937_64 random(42);
  const scene::World world = world_of({scene::Sphere{{0, 0, 0}, 1}, scene::Box{{-1, -1, -1}, {1, 1, 1}},
                                       scene::Frustum{{0, 0, -1}, {0, 0, 1}, 1, 1}});
  const Balls balls(world);
  std::vector<Near> memory;
  int kept = 0;
  for (int i = 0; i < 1'000; ++i) {
    const Vec3 direction = random_direction(random);
    const Vec3 aside = glm::normalize(glm::cross(direction, random_direction(random)));
    // All three bodies fit into a ball of radius sqrt(3) at the origin; the sphere into 1.
    kept += static_cast<int>(balls.gather({aside * 1.74 - direction * 10.0, direction}, memory).size());
    kept += balls.may_meet(0, {aside * 1.0001 - direction * 10.0, direction}) ? 1 : 0;
    kept += balls.may_meet(1, {direction * 2.0, direction}) ? 1 : 0; // behind
  }
  CHECK(kept == 0);
}

TEST_CASE("balls are tight about what they hold") {
  const scene::World world =
      world_of({scene::Sphere{{3, 1, 0}, 2}, scene::Frustum{{0, 0, 0}, {0, 0, 4}, 1.5, 1.5},
                scene::Frustum{{0, 0, 0}, {0, 0, 3}, 4, 0}, scene::Box{{0, 0, 0}, {2, 4, 4}}});
  CHECK(bounding_ball(world, world.bodies[0]).radius == Approx(2));
  CHECK(bounding_ball(world, world.bodies[1]).radius == Approx(2.5));
  CHECK(bounding_ball(world, world.bodies[2]).radius == Approx(4));
  CHECK(bounding_ball(world, world.bodies[3]).radius == Approx(3));
}
