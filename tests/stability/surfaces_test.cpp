#include "support/random_scene.h"
#include "tally.h"

#include <halftone/geometry/solids.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

// No surface is met by a ray that leaves it, and none is slipped through at an edge, at any size and distance
// from the origin; without an epsilon, by fact.

using namespace halftone;

namespace {

std::string at(std::uint64_t seed, int ray) {
  std::ostringstream text;
  text << "seed " << seed << ", ray " << ray;
  return text.str();
}

core::Vec3 random_direction(test::RandomScene& random) {
  return glm::normalize(core::Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
}

scene::World random_solids(test::RandomScene& random, std::uint64_t seed) {
  scene::Scene built = random.make({6, true, true, false});
  const double by = std::exp2(random.uniform(-20, 20)), far = seed % 3 == 0 ? 1e5 : 0;
  for (scene::Object& object : built.objects) {
    object.placement.scale *= by;
    object.placement.translate = (object.placement.translate + core::Vec3{far, 2 * far, far}) * by;
  }
  return scene::make_world(built);
}

/// Rays that arrive at a random place of a solid and leave it from there on the side that they came from.
void leave(std::uint64_t seed, int rays, test::Tally& tally) {
  test::RandomScene random(seed);
  const scene::World world = random_solids(random, seed);
  const geometry::Solids solids(world);
  for (int k = 0; k < rays; ++k) {
    const int body = random.pick(static_cast<int>(world.bodies.size()));
    const scene::Body& solid = world.bodies[body];
    if (solid.kind == scene::BodyKind::polygon) continue;
    const core::Vec3 middle = (solid.bounds[0] + solid.bounds[1]) / 2.0;
    const double size = glm::length(solid.bounds[1] - solid.bounds[0]);
    const core::Vec3 direction = random_direction(random);
    const geometry::Line arrives{middle + size * 0.3 * random_direction(random) - direction * (2 * size),
                                 direction, -1, false};
    const auto span = solids.span(body, arrives);
    if (!span) continue;
    const int surface = solid.faces[span->in.face].surface;
    const core::Vec3 point = arrives.origin + direction * span->in.t;
    core::Vec3 normal = scene::normal_at(world.surfaces[surface], point);
    if (solid.faces[span->in.face].flipped) normal = -normal;
    core::Vec3 away = random_direction(random);
    if (random.pick(3) == 0) away -= normal * glm::dot(normal, away) * (1 - 1e-9); // nearly along the surface
    away = glm::normalize(glm::dot(away, normal) < 0 ? -away : away);
    const geometry::Line leaves{point, away, surface, !solid.faces[span->in.face].flipped};
    tally.add(0, solids.span(body, leaves).has_value(), at(seed, k) + ", leaving");
    // The same ray turned inwards leaves once, ahead.
    const geometry::Line enters{point, -away, surface, solid.faces[span->in.face].flipped};
    const double t = solids.exit(body, enters).t;
    tally.add(0, !(t >= 0 && t <= 2 * size), at(seed, k) + ", entering");
  }
}

test::Tally self_hits(std::uint64_t scenes, int rays) {
  return test::tally_of("self-hits", scenes,
                        [&](std::uint64_t seed, auto& tally) { leave(seed, rays, tally); });
}

/// From inside a box of six polygons at its edges and corners: one of them is met.
void aim_at_edges(std::uint64_t seed, int rays, test::Tally& tally) {
  test::RandomScene random(seed);
  scene::Scene built;
  built.materials.resize(1);
  const core::Vec3 size{std::exp2(random.uniform(-8, 8)), std::exp2(random.uniform(-8, 8)),
                        std::exp2(random.uniform(-8, 8))};
  const core::Vec3 low{random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100)};
  const auto corner = [&](int k) {
    return low + size * core::Vec3{k & 1 ? 1.0 : 0.0, k & 2 ? 1.0 : 0.0, k & 4 ? 1.0 : 0.0};
  };
  const int sides[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  const core::Vec3 turn{random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180)};
  for (const auto& side : sides) {
    scene::Object object;
    object.shape = scene::Polygon{{corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3])}};
    object.placement.rotate = turn;
    built.objects.push_back(object);
  }
  const scene::World world = scene::make_world(built);
  const geometry::Solids solids(world);
  for (int k = 0; k < rays; ++k) {
    const auto& outline = world.bodies[random.pick(6)].faces[0].outline;
    const int edge = random.pick(4);
    const double s = random.pick(4) == 0 ? 0 : random.uniform(0, 1);
    const core::Vec3 target = outline[edge] + s * (outline[(edge + 1) % 4] - outline[edge]);
    core::Vec3 middle{0};
    for (const scene::Body& body : world.bodies)
      for (const core::Vec3& p : body.faces[0].outline) middle += p / 24.0;
    const core::Vec3& other = world.bodies[random.pick(6)].faces[0].outline[random.pick(4)];
    const core::Vec3 from = middle + random.uniform(0, 0.9) * (other - middle);
    const geometry::Line line{from, glm::normalize(target - from), -1, false};
    bool met = false;
    for (int body = 0; body < 6; ++body) met = met || solids.crossing(body, line);
    tally.add(0, !met, at(seed, k));
  }
}

test::Tally leaks(std::uint64_t boxes, int rays) {
  return test::tally_of("leaks", boxes,
                        [&](std::uint64_t seed, auto& tally) { aim_at_edges(seed, rays, tally); });
}

/// None may pass for lack of cases.
void check(const test::Tally& tally, std::uint64_t least) {
  CHECK(tally.cases >= least);
  CHECK(tally.failures == 0);
}

} // namespace

TEST_CASE("no ray returns to the solid that it leaves, and every ray inside leaves") {
  check(self_hits(300, 200), 300 * 100);
}

TEST_CASE("no ray slips through the edges and corners of a closed box of polygons") {
  check(leaks(300, 200), 300 * 200);
}

TEST_CASE("no ray returns and none slips through, many", "[.][long]") {
  check(self_hits(110'000, 1000), 100'000'000);
  check(leaks(100'000, 1000), 100'000'000);
}
