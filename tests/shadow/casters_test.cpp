#include "support/random_scene.h"

#include <halftone/shadow/casters.h>

#include <catch2/catch.hpp>

using namespace halftone;

namespace {

std::vector<std::vector<int>> casters_of(const scene::World& world) {
  std::vector<geometry::Hull> hulls;
  for (const scene::Body& body : world.bodies) hulls.push_back(geometry::bounding_hull(world, body));
  return shadow::casters_by_light(world, hulls);
}

/// A tilted square with a box on either side.
scene::Scene boxes_about_a_board(test::RandomScene& random) {
  scene::Scene built;
  built.camera = {{0, -8, 3}, {0, 0, 0}, {0, 0, 1}, 40};
  built.materials.resize(1);
  built.objects.resize(3);
  built.objects[0].shape = scene::Polygon{{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}};
  built.objects[1].shape = scene::Box{{-0.3, -0.3, 1}, {0.3, 0.3, 1.5}};
  built.objects[2].shape = scene::Box{{-0.3, -0.3, -1.5}, {0.3, 0.3, -1}};
  const core::Vec3 turn{random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180)};
  for (scene::Object& object : built.objects) object.placement.rotate = turn;
  return built;
}

} // namespace

TEST_CASE("what lies wholly in the shadow of a large face is no caster, and what stands before it is") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    test::RandomScene random(seed);
    scene::Scene built = boxes_about_a_board(random);
    built.lights.resize(1);
    const scene::World plain = scene::make_world(built);
    const auto& board = std::get<scene::Plane>(plain.surfaces[plain.bodies[0].faces[0].surface]);
    // On the side of the second box, and on that of the third.
    const core::Vec3 side =
        board.normal * (glm::dot(board.normal, plain.bodies[1].faces[0].outline[0]) > 0 ? 4.0 : -4.0);
    built.lights[0].position = side;
    INFO("seed " << seed);
    CHECK(casters_of(scene::make_world(built))[0] == std::vector<int>{0, 1});
    built.lights[0].position = -side;
    CHECK(casters_of(scene::make_world(built))[0] == std::vector<int>{0, 2});
  }
}

TEST_CASE("a board with the light on it hides nothing, however rounding puts the light") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    test::RandomScene random(seed);
    scene::Scene built = boxes_about_a_board(random);
    const scene::World plain = scene::make_world(built);
    const std::vector<core::Vec3>& corners = plain.bodies[0].faces[0].outline;
    const double u = random.uniform(0.3, 0.7), v = random.uniform(0.3, 0.7);
    built.lights.push_back(
        {corners[0] + u * (corners[1] - corners[0]) + v * (corners[3] - corners[0]), core::Color{1}});
    INFO("seed " << seed);
    CHECK(casters_of(scene::make_world(built))[0] == std::vector<int>{0, 1, 2});
  }
}
