#include "support/random_scene.h"
#include "tally.h"

#include <halftone/reference/reference.h>
#include <halftone/trace/trace.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <sstream>

// Glass on glass, glass on opaque, opaque on opaque, polygons on faces: stacks of all pairs of shapes, turned
// and moved at random. Every ray brings what the brute-force renderer says.

using namespace halftone;

namespace {

/// On z = 0, with a flat base; the next can stand at its height.
scene::Object standing(test::RandomScene& random, double z, double& height) {
  scene::Object object;
  const double size = random.uniform(0.3, 1.2);
  height = random.uniform(0.2, 1);
  const core::Vec3 base{0, 0, z}, top{0, 0, z + height};
  switch (random.pick(5)) {
  case 0:
    object.shape = scene::Box{{-size, -size * 0.7, z}, {size * 0.8, size, z + height}};
    break;
  case 1:
    object.shape = scene::Prism{base, top, size, 3 + random.pick(5), random.uniform(0, 90)};
    break;
  case 2:
    object.shape = scene::Frustum{base, top, size, size};
    break;
  case 3:
    object.shape = scene::Frustum{base, top, size, size * random.uniform(0.2, 1.6)};
    break;
  default:
    object.shape = scene::Polygon{{{-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z}}};
    height = 0;
  }
  const bool is_polygon = height == 0;
  object.material = random.pick(is_polygon ? 2 : 4);
  return object;
}

scene::Scene stack(test::RandomScene& random) {
  scene::Scene built;
  built.image.width = 64;
  built.image.height = 48;
  built.background = {0.3, 0.4, 0.6};
  built.ambient = core::Color{0.2};
  built.materials.resize(4);
  built.materials[0].diffuse = {0.8, 0.3, 0.2};
  built.materials[1].diffuse = {0.2, 0.3, 0.8};
  built.materials[1].specular = core::Color{0.3};
  built.materials[2].glass = scene::Glass{1.5, {0.1, 0.2, 0.3}};
  built.materials[3].glass = scene::Glass{random.uniform(1, 2), {0.3, 0.1, 0}};
  built.materials[2].diffuse = built.materials[3].diffuse = core::black;
  double z = 0;
  for (int k = 0; k < 4; ++k) {
    double height = 0;
    built.objects.push_back(standing(random, z, height));
    z += height;
  }
  const core::Vec3 turn{random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180)};
  const core::Vec3 move{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
  for (scene::Object& object : built.objects) object.placement = {1, turn, move};
  const auto around = [&](double distance) {
    return move + distance * glm::normalize(core::Vec3{random.uniform(-1, 1), random.uniform(-1, 1),
                                                       random.uniform(-1, 1)});
  };
  built.camera = {around(7), move, {0, 0, 1}, 35};
  built.lights.push_back({around(9), core::Color{0.7}});
  built.lights.push_back({around(6), core::Color{0.4}});
  return built;
}

void throw_rays(std::uint64_t seed, int rays, test::Tally& tally) {
  test::RandomScene random(seed);
  const scene::World world = scene::make_world(stack(random));
  const trace::Tracer tracer(world);
  const reference::Reference reference(world);
  std::vector<int> bodies(world.bodies.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  trace::Counts counts;
  reference::Counts ignored;
  double worst = 0;
  int differing = 0;
  for (int k = 0; k < rays; ++k) {
    const double x = random.uniform(16, 48), y = random.uniform(12, 36);
    const trace::EyeRay ray{world.camera.direction(x, y), bodies};
    trace::Sample sample;
    tracer.trace({&ray, 1}, {&sample, 1}, counts);
    const double off = core::max_component(glm::abs(sample.radiance - reference.radiance(x, y, ignored)));
    if (!(off <= 1e-9)) ++differing;
    worst = std::max(worst, off);
  }
  std::ostringstream which;
  which << "seed " << seed << ": " << differing << " rays";
  tally.add(worst, differing > 0, which.str());
}

test::Tally contacts(std::uint64_t stacks, int rays) {
  return test::tally_of("stacks", stacks,
                        [&](std::uint64_t seed, auto& tally) { throw_rays(seed, rays, tally); });
}

} // namespace

TEST_CASE("in stacks of things that touch every ray brings what the reference says") {
  CHECK(contacts(200, 100).failures == 0);
}

TEST_CASE("in stacks of things that touch every ray brings what the reference says, many", "[.][long]") {
  CHECK(contacts(50'000, 200).failures == 0);
}
