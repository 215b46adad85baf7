#include "against_reference.h"
#include "support/random_scene.h"
#include "tally.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

// Degenerate views: eyes on planes, edges, corners and rims, inside solids, very near and very far; fields of
// view of 0.01 and 179 degrees; edges exactly on pixel borders. Default rows against the brute-force
// renderer; no radiance that is not a number.

using namespace halftone;

namespace {

const char* const kinds[] = {"eye on the floor's plane",
                             "eye in an object",
                             "eye at an object's corner",
                             "narrow",
                             "wide",
                             "far away",
                             "straight down",
                             "eye on the floor",
                             "objects behind the eye",
                             "edges on pixel borders",
                             "a light at the eye",
                             "eye on an edge of a turned box",
                             "eye on the rim of a turned cylinder"};
constexpr int kind_count = 13;

/// The eye on a part of the last object, which is turned about z.
void put_eye_on(scene::Scene& built, test::RandomScene& random, const scene::Shape& shape,
                const core::Vec3& part) {
  scene::Object& object = built.objects.back();
  const double angle = random.uniform(-3, 3);
  object = {};
  object.shape = shape;
  object.material = 2 + random.pick(5);
  object.placement.rotate.z = angle * 180 / 3.14159265358979323846;
  object.placement.translate = {random.uniform(-2, 2), random.uniform(-2, 2), 0};
  built.camera.eye =
      object.placement.translate + core::Vec3{std::cos(angle) * part.x - std::sin(angle) * part.y,
                                              std::sin(angle) * part.x + std::cos(angle) * part.y, part.z};
  built.camera.target = {random.uniform(-3, 3), random.uniform(-3, 3), 0.2};
}

scene::Scene view(std::uint64_t seed) {
  test::RandomScene random(seed);
  scene::Scene built = random.make({6, true, true, seed % 4 == 0});
  built.image.width = 32;
  built.image.height = 24;
  built.camera.target = {0, 0, 0.5};
  const core::Vec3 object = built.objects.back().placement.translate;
  switch (seed % kind_count) {
  case 0:
    built.camera.eye.z = 0;
    break;
  case 1:
    built.camera.eye = object + core::Vec3{0.01, 0.02, 0.1};
    break;
  case 2:
    built.objects.back() = {};
    built.objects.back().shape = scene::Box{{-0.5, -0.5, 0}, {0.5, 0.5, 1}};
    built.objects.back().material = 2 + random.pick(5);
    built.camera.eye = {0.5, -0.5, 1};
    built.camera.target = {random.uniform(-3, 3), random.uniform(-3, 3), 0.2};
    break;
  case 3:
    built.camera.fov = 0.01;
    break;
  case 4:
    built.camera.fov = 179;
    break;
  case 5:
    built.camera.eye *= 1e6;
    built.camera.fov = 4e-5;
    break;
  case 6:
    built.camera.eye = {0, 0, 7};
    built.camera.up = {0, 1, 0};
    break;
  case 7:
    built.camera.eye = {random.uniform(-3, 3), random.uniform(-3, 3), 0};
    break;
  case 8:
    built.camera.eye = {0, 0, 1};
    built.camera.target = {1, random.uniform(-1, 1), 0.7};
    break;
  case 9:
    built.camera.eye = {0, 0, 12};
    built.camera.up = {0, 1, 0};
    built.camera.target = {0, 0, 0};
    built.camera.fov = 2 * std::atan(1.0) * 180 / 3.14159265358979323846; // a unit is a pixel at z = 0
    for (scene::Object& o : built.objects)
      o.placement = {
          1, {0, 0, 90.0 * random.pick(4)}, {1.0 * random.pick(9) - 4, 1.0 * random.pick(9) - 4, 0}};
    break;
  case 10:
    built.lights[0].position = built.camera.eye;
    break;
  case 11:
    put_eye_on(built, random, scene::Box{{-0.5, -0.7, 0}, {0.5, 0.7, 1}}, {0.5, 0.7, random.uniform(0.1, 1)});
    break;
  default:
    put_eye_on(built, random, scene::Frustum{{0, 0, 0}, {0, 0, 1}, 0.6, 0.6}, {0.6, 0, 1});
  }
  return built;
}

void draw(std::uint64_t seed, test::Tally& tally) {
  test::add_picture(view(seed), "seed " + std::to_string(seed) + ", " + kinds[seed % kind_count], tally);
}

test::Tally views(std::uint64_t count) { return test::tally_of("views", count, draw); }

} // namespace

TEST_CASE("degenerate views are what the reference shows") { CHECK(views(44).failures == 0); }

TEST_CASE("an eye on an edge of a box sees what the reference shows") {
  test::Tally tally;
  for (const std::uint64_t seed : {24, 115, 193, 245, 284, 362, 687, 934})
    draw(seed, tally); // found by [long]
  test::tell("views: eye on an edge", tally);
  CHECK(tally.failures == 0);
}

TEST_CASE("an eye in two solids that stand on a floor sees the floor without their shadows") {
  test::Tally tally;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    test::RandomScene random(seed);
    scene::Scene built = random.make({0, false, false, false});
    built.image.width = 32;
    built.image.height = 24;
    for (const double x : {-0.3, 0.3}) {
      scene::Object object;
      object.shape = seed % 2 == 0 ? scene::Shape(scene::Prism{{0, 0, 0}, {0, 0, 1}, 0.9, 5, 10})
                                   : scene::Shape(scene::Frustum{{0, 0, 0}, {0, 0, 1}, 0.9, 0.7});
      object.material = 2 + random.pick(3);
      object.placement.translate = {x, 0, 0};
      built.objects.push_back(object);
    }
    built.camera.eye = {0.01, 0.02, 0.8};
    built.camera.target = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0};
    test::add_picture(built, "seed " + std::to_string(seed), tally);
  }
  test::tell("views: eye in two solids", tally);
  CHECK(tally.failures == 0);
}

TEST_CASE("degenerate views are what the reference shows, many", "[.][long]") {
  CHECK(views(3'000).failures == 0);
}
