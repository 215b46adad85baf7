#include "against_reference.h"
#include "support/random_scene.h"
#include "tally.h"

#include <halftone/render/render.h>
#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

// Lights in special places: on surfaces, edges and corners, inside glass and opaque solids, at the eye, in
// the planes of faces, between solids in contact; and low over round bodies, whose terminator has to be
// smooth. Default rows against the brute-force renderer; no radiance that is not a number.

using namespace halftone;
using core::Vec3;

namespace {

const char* const kinds[] = {"on the floor",
                             "on a face",
                             "on an edge",
                             "on a corner",
                             "on a round side",
                             "inside glass",
                             "inside an opaque solid",
                             "at the eye",
                             "at the eye on a face",
                             "in the plane of a face",
                             "in the plane of a polygon",
                             "between solids in contact",
                             "low over round bodies"};
constexpr int kind_count = 13;
constexpr int glass = 6; ///< of the random scenes' materials; 2 to 4 are opaque

Vec3 random_unit(test::RandomScene& random) {
  return glm::normalize(Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
}

/// A box, a prism, a sphere, a cylinder or a cone of a size of about 1 that stands at the origin.
scene::Shape standing(test::RandomScene& random) {
  switch (random.pick(5)) {
  case 0:
    return scene::Box{{-0.6, -0.5, 0}, {0.6, 0.5, 1}};
  case 1:
    return scene::Prism{{0, 0, 0}, {0, 0, 1}, 0.7, 3 + random.pick(6), random.uniform(0, 90)};
  case 2:
    return scene::Sphere{{0, 0, 0.7}, 0.7};
  case 3:
    return scene::Frustum{{0, 0, 0}, {0, 0, 1}, 0.6, 0.6};
  default:
    return scene::Frustum{{0, 0, 0}, {0, 0, 1.5}, 0.8, 0};
  }
}

/// The scene's last object stands at the origin; lights[0] is the one in question.
scene::Scene lit(std::uint64_t seed) {
  test::RandomScene random(seed);
  scene::Scene built = random.make({5, true, true, seed % 4 == 0});
  built.image.width = 32;
  built.image.height = 24;
  built.camera.target = {0, 0, 0.5};
  built.lights[1].color *= 0.3;
  const auto stand = [&](const scene::Shape& shape, int material) {
    scene::Object object;
    object.shape = shape;
    object.material = material;
    built.objects.push_back(object);
  };
  const scene::Shape box = scene::Box{{-0.6, -0.5, 0}, {0.6, 0.5, 1}};
  const int any = random.pick(2) == 0 ? glass : 2 + random.pick(3);
  Vec3& light = built.lights[0].position;
  switch (seed % kind_count) {
  case 0:
    light = {random.uniform(-3, 3), random.uniform(-3, 3), 0};
    break;
  case 1:
    stand(box, any);
    light = random.pick(2) == 0 ? Vec3{random.uniform(-0.6, 0.6), random.uniform(-0.5, 0.5), 1}
                                : Vec3{0.6, random.uniform(-0.5, 0.5), random.uniform(0, 1)};
    break;
  case 2:
    stand(box, any);
    light =
        random.pick(2) == 0 ? Vec3{random.uniform(-0.6, 0.6), -0.5, 1} : Vec3{0.6, 0.5, random.uniform(0, 1)};
    break;
  case 3:
    stand(box, any);
    light = {random.pick(2) == 0 ? 0.6 : -0.6, random.pick(2) == 0 ? 0.5 : -0.5, random.pick(3) == 0 ? 0 : 1};
    break;
  case 4:
    if (random.pick(2) == 0) {
      stand(scene::Sphere{{0, 0, 0.7}, 0.7}, any);
      light = Vec3{0, 0, 0.7} + 0.7 * random_unit(random);
    } else {
      stand(scene::Frustum{{0, 0, 0}, {0, 0, 1}, 0.6, 0.6}, any);
      const double around = random.uniform(0, 6.28);
      light = {0.6 * std::cos(around), 0.6 * std::sin(around), random.uniform(0, 1)};
    }
    break;
  case 5:
    stand(standing(random), glass);
    light = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(0.2, 0.9)};
    break;
  case 6:
    stand(standing(random), 2 + random.pick(3));
    light = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(0.2, 0.9)};
    break;
  case 7:
    light = built.camera.eye;
    break;
  case 8:
    stand(box, any);
    light = built.camera.eye = {random.uniform(-0.5, 0.5), random.uniform(-0.4, 0.4), 1};
    built.camera.target = {random.uniform(-3, 3), random.uniform(-3, 3), 0.2};
    break;
  case 9:
    stand(box, any);
    light = random.pick(2) == 0 ? Vec3{random.uniform(-4, 4), random.uniform(-4, 4), 1}
                                : Vec3{0.6, random.uniform(-4, 4), random.uniform(0.2, 4)};
    break;
  case 10:
    stand(scene::Polygon{{{-1, 0.25, 0}, {1, 0.25, 0}, {1, 0.25, 1}, {0, 0.25, 2}}}, 2 + random.pick(3));
    light = {random.uniform(-4, 4), 0.25, random.uniform(0.2, 4)};
    break;
  case 11:
    stand(box, any);
    stand(scene::Frustum{{0, 0, 1}, {0, 0, 1.5}, 0.4, 0.3}, random.pick(2) == 0 ? glass : 3);
    light = {random.uniform(-0.45, 0.45), random.uniform(-0.45, 0.45), 1};
    break;
  default: {
    built.objects.resize(1);
    stand(standing(random), 2 + random.pick(3));
    scene::Object other;
    other.shape = scene::Sphere{{0, 0, 0.5}, 0.5};
    other.material = 2 + random.pick(3);
    other.placement.translate = {random.uniform(1, 2), random.uniform(-1, 1), random.uniform(0, 0.5)};
    built.objects.push_back(other);
    const double around = random.uniform(0, 6.28), far = random.uniform(3, 100);
    light = {far * std::cos(around), far * std::sin(around), far * random.uniform(0.001, 0.2)};
    built.lights[0].color = core::Color{0.8};
  }
  }
  return built;
}

void draw(std::uint64_t seed, test::Tally& tally) {
  test::add_picture(lit(seed), "seed " + std::to_string(seed) + ", " + kinds[seed % kind_count], tally);
}

test::Tally lights(std::uint64_t count) { return test::tally_of("lights", count, draw); }

std::vector<core::Color> drawn(const scene::Scene& scene) {
  std::vector<core::Color> picture;
  render::render(scene, {.threads = 1}, [&](const render::Row& row) {
    picture.insert(picture.end(), row.radiance.begin(), row.radiance.end());
  });
  return picture;
}

/// In levels that are not rounded.
double farthest_apart(const scene::Scene& one, const scene::Scene& other) {
  const auto a = drawn(one), b = drawn(other);
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (int channel = 0; channel < 3; ++channel)
      worst = std::max(worst, std::abs(shade::display_level(a[k][channel], one.image) -
                                       shade::display_level(b[k][channel], one.image)));
  return worst;
}

} // namespace

TEST_CASE("a light on an edge of a solid lights what one a little off it lights") {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    test::RandomScene random(seed);
    scene::Scene built = random.make({0, false, false, false});
    built.image.width = 32;
    built.image.height = 24;
    built.lights.resize(1);
    scene::Object box;
    box.shape = scene::Box{{-0.6, -0.5, -0.4}, {0.6, 0.5, 0.4}};
    box.material = seed % 2 == 0 ? 6 : 0; // glass, or without a highlight, which comes and goes at n . l = 0
    box.placement.rotate.z = random.uniform(0, 360);
    box.placement.translate.z = 0.4;
    built.objects.push_back(box);
    const double around = box.placement.rotate.z * 3.14159265358979323846 / 180;
    const Vec3 edge{0.6, 0.5, random.uniform(-0.4, 0.4)};
    const auto turned = [&](const Vec3& p) {
      return Vec3{p.x * std::cos(around) - p.y * std::sin(around),
                  p.x * std::sin(around) + p.y * std::cos(around), p.z + 0.4};
    };
    built.lights[0].position = turned(edge);
    scene::Scene off = built;
    off.lights[0].position = turned(edge + Vec3{1e-9, 1e-9, 0}); // as far off both faces
    INFO("seed " << seed);
    CHECK(farthest_apart(built, off) < 1);
  }
}

TEST_CASE("a light in the plane of a face makes no highlight on it") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::RandomScene random(seed);
    scene::Scene built = random.make({0, false, false, false});
    const double a = random.uniform(-0.5, 0.5), b = random.uniform(-0.5, 0.5);
    const auto on_plane = [&](double x, double y) { return Vec3{x, y, a * x + b * y}; };
    built.objects[0].shape =
        scene::Polygon{{on_plane(-6, -6), on_plane(6, -6), on_plane(6, 6), on_plane(-6, 6)}};
    built.objects[0].material = 2;
    built.objects[0].trace = seed % 2 == 0 ? scene::TraceRule::always : scene::TraceRule::automatic;
    built.lights.resize(1);
    built.lights[0].position = on_plane(random.uniform(-8, 8), random.uniform(-8, 8));
    scene::Scene unlit = built;
    unlit.lights.clear();
    INFO("seed " << seed);
    CHECK(farthest_apart(built, unlit) < 1e-9);
  }
}

TEST_CASE("lights in special places light what the reference shows") { CHECK(lights(26).failures == 0); }

TEST_CASE("lights in special places light what the reference shows: many", "[.][long]") {
  CHECK(lights(2'600).failures == 0);
}
