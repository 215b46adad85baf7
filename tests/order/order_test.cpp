#include "cut.h"
#include "support/random_scene.h"

#include <halftone/order/order.h>

#include <catch2/catch.hpp>

using namespace halftone;

namespace {

/// Where a line of sight meets a body first.
std::optional<double> depth(const scene::World& world, int body, const reference::Line& line) {
  if (world.bodies[body].kind == scene::BodyKind::polygon) {
    const auto crossing = reference::cross(world, world.bodies[body], line);
    return crossing ? std::optional(crossing->t) : std::nullopt;
  }
  const auto span = reference::cut(world, world.bodies[body], line);
  return span && span->in.t > 0 ? std::optional(span->in.t) : std::nullopt;
}

std::vector<geometry::Hull> hulls_of(const scene::World& world) {
  std::vector<geometry::Hull> hulls;
  for (const scene::Body& body : world.bodies) hulls.push_back(geometry::bounding_hull(world, body));
  return hulls;
}

} // namespace

TEST_CASE("an order relation agrees with the depths along every line of sight that meets both bodies") {
  int decided = 0, varied = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    test::RandomScene random(seed);
    const scene::World world = scene::make_world(random.make({8, true, true, seed % 2 == 0}));
    const auto hulls = hulls_of(world);
    order::Order order(world, hulls);
    for (int i = 0; i < 1'500; ++i) {
      const double x = random.uniform(0, 64), y = random.uniform(0, 48);
      const reference::Line line{world.camera.eye, world.camera.direction(x, y), -1, false};
      std::vector<std::pair<int, double>> met;
      for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b)
        if (const auto t = depth(world, b, line)) met.emplace_back(b, *t);
      for (const auto& [a, depth_a] : met)
        for (const auto& [b, depth_b] : met) {
          if (a == b) continue;
          INFO("seed " << seed << ", ray " << i << " at " << x << ", " << y << ", bodies " << a << " and "
                       << b);
          const order::Front front = order.compare(a, b);
          ++(front == order::Front::varies ? varied : decided);
          // What touches is at equal depth up to rounding.
          if (front == order::Front::first) REQUIRE(depth_a <= depth_b + 1e-9);
          if (front == order::Front::second) REQUIRE(depth_b <= depth_a + 1e-9);
        }
    }
    CHECK(order.known() <= world.bodies.size() * (world.bodies.size() - 1) / 2);
  }
  CHECK(decided > 20'000);
  CHECK(varied > 1'000); // the scenes are full of things that pass through each other
}

TEST_CASE("relations are found when they are asked for, once for a pair") {
  test::RandomScene random(3);
  const scene::World world = scene::make_world(random.make({}));
  const auto hulls = hulls_of(world);
  order::Order order(world, hulls);
  CHECK(order.known() == 0);
  const order::Front front = order.compare(2, 5);
  CHECK(order.known() == 1);
  const order::Front back = order.compare(5, 2);
  CHECK(order.known() == 1);
  CHECK((front == order::Front::varies ? back == front : back != front));
}

TEST_CASE("touching bodies have an order, and bodies that pass through each other have none") {
  scene::Scene built;
  built.camera = {{0, -10, 5}, {0, 0, 0}, {0, 0, 1}, 40};
  built.materials.push_back({});
  const auto add = [&](scene::Shape shape) {
    scene::Object object;
    object.shape = std::move(shape);
    built.objects.push_back(std::move(object));
  };
  add(scene::Polygon{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}});
  add(scene::Box{{-1, -1, 0}, {1, 1, 1}});
  add(scene::Frustum{{0, 0, 1}, {0, 0, 2}, 0.5, 0.5});
  add(scene::Box{{0.5, -0.5, 0.5}, {2, 0.5, 3}});
  add(scene::Polygon{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
  const scene::World world = scene::make_world(built);
  const auto hulls = hulls_of(world);
  order::Order order(world, hulls);
  CHECK(order.compare(1, 0) == order::Front::first);
  CHECK(order.compare(1, 2) == order::Front::second);
  CHECK(order.compare(1, 3) == order::Front::varies);
  CHECK(order.compare(4, 0) == order::Front::first); // of coinciding polygons the last in the file
}
