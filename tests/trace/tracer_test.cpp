#include "support/random_scene.h"
#include "support/skip.h"

#include <halftone/reference/reference.h>
#include <halftone/scene/read.h>
#include <halftone/trace/trace.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <thread>

using namespace halftone;

namespace {

std::vector<int> all_bodies(const scene::World& world) {
  std::vector<int> bodies(world.bodies.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  return bodies;
}

struct Position {
  double x = 0;
  double y = 0;
};

std::vector<Position> random_positions(const scene::World& world, int count, std::uint64_t seed) {
  test::RandomScene random(seed);
  std::vector<Position> positions;
  for (int i = 0; i < count; ++i)
    positions.push_back({random.uniform(0, world.camera.width), random.uniform(0, world.camera.height)});
  return positions;
}

std::vector<trace::Sample> traced(const scene::World& world, const std::vector<Position>& positions,
                                  std::size_t batch) {
  const trace::Tracer tracer(world);
  const std::vector<int> bodies = all_bodies(world);
  std::vector<trace::EyeRay> rays;
  for (const Position& p : positions) rays.push_back({world.camera.direction(p.x, p.y), bodies});
  std::vector<trace::Sample> samples(rays.size());
  trace::Counts counts;
  for (std::size_t i = 0; i < rays.size(); i += batch) {
    const std::size_t count = std::min(batch, rays.size() - i);
    tracer.trace(std::span(rays).subspan(i, count), std::span(samples).subspan(i, count), counts);
  }
  return samples;
}

/// How many rays differ from the reference by more than 1e-9.
int differing(const scene::World& world, int rays, std::uint64_t seed) {
  const std::vector<Position> positions = random_positions(world, rays, seed);
  const std::vector<trace::Sample> samples = traced(world, positions, 1024);
  const reference::Reference reference(world);
  reference::Counts counts;
  int count = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const core::Color wanted = reference.radiance(positions[i].x, positions[i].y, counts);
    if (!(core::max_component(glm::abs(samples[i].radiance - wanted)) <= 1e-9)) ++count;
  }
  return count;
}

} // namespace

TEST_CASE("a traced ray brings what the reference says, on the ten scenes") {
  for (const std::string name :
       {"fig9a", "fig9b", "contact", "nested", "inside", "mirrors", "sliver", "cyclic", "opaque", "round"}) {
    const scene::World world =
        scene::make_world(scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml"));
    INFO(name);
    // Rays that graze an edge within rounding may fall to either side.
    CHECK(differing(world, 4'000, 21) <= 2);
  }
}

TEST_CASE("a traced ray brings what the reference says, on random scenes") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const scene::World world =
        scene::make_world(test::RandomScene(seed).make({9, true, true, seed % 4 == 0}));
    INFO("seed " << seed);
    CHECK(differing(world, 800, seed) <= 1);
  }
}

TEST_CASE("samples have the same bits however a batch is cut, and from several threads") {
  const scene::World world = scene::make_world(test::RandomScene(5).make({}));
  const std::vector<Position> positions = random_positions(world, 1'500, 5);
  const std::vector<trace::Sample> whole = traced(world, positions, positions.size());
  const auto check = [&](const std::vector<trace::Sample>& samples) {
    int different = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
      different += samples[i].radiance != whole[i].radiance || samples[i].first != whole[i].first ||
                   samples[i].tree != whole[i].tree;
    return different;
  };
  CHECK(check(traced(world, positions, 1)) == 0);
  CHECK(check(traced(world, positions, 7)) == 0);
  std::vector<std::vector<trace::Sample>> results(3);
  {
    std::vector<std::jthread> threads;
    for (auto& result : results) threads.emplace_back([&] { result = traced(world, positions, 100); });
  }
  for (const auto& result : results) CHECK(check(result) == 0);
}

TEST_CASE(
    "signatures tell an edge seen through glass from its surroundings, and a smooth region from nothing") {
  scene::Scene built;
  built.image.width = built.image.height = 64;
  built.camera = {{0, -6, 0}, {0, 0, 0}, {0, 0, 1}, 30};
  built.materials.resize(2);
  built.materials[1].glass = scene::Glass{1.5, core::Color{0}};
  built.materials[1].diffuse = core::black;
  built.objects.resize(2);
  built.objects[0].shape = scene::Box{{-3, 0, -3}, {3, 1, 3}};
  built.objects[0].material = 1;
  built.objects[1].shape = scene::Box{{0, 3, -3}, {3, 4, 3}}; // the right half, behind the plate
  const scene::World world = scene::make_world(built);
  const auto samples = traced(world, {{8, 30}, {20, 30}, {44, 30}, {56, 30}}, 4);
  for (const trace::Sample& sample : samples) CHECK(sample.first == samples[0].first);
  CHECK(samples[0].tree == samples[1].tree);
  CHECK(samples[2].tree == samples[3].tree);
  CHECK(samples[1].tree != samples[2].tree);
}

TEST_CASE("an eye on an edge of a turned block sees nothing of it beside either face") {
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> angle(-180, 180), part(-0.9, 0.9);
  for (int i = 0; i < 300; ++i) {
    scene::Scene built;
    built.background = core::Color{1};
    built.materials.resize(1);
    if (i % 2 == 0) built.materials[0].glass = scene::Glass{1.5, core::Color{0}};
    built.objects.resize(1);
    built.objects[0].shape = scene::Box{{-1, -1, -1}, {1, 1, 1}};
    const double degrees = angle(random), radians = degrees * std::acos(-1.0) / 180;
    built.objects[0].placement.rotate = {0, 0, degrees};
    const auto turned = [&](const core::Vec3& p) {
      return core::Vec3{std::cos(radians) * p.x - std::sin(radians) * p.y,
                        std::sin(radians) * p.x + std::cos(radians) * p.y, p.z};
    };
    built.camera.eye = turned({1, 1, part(random)});
    built.camera.target = built.camera.eye + core::Vec3{1, 0, 0};
    const scene::World world = scene::make_world(built);
    const std::vector<int> bodies = all_bodies(world);
    // Into the half-space of one face, out of the other's; and into both.
    std::vector<trace::EyeRay> rays;
    for (const core::Vec3& along :
         {core::Vec3{-1, 0.25, 0.5}, core::Vec3{0.25, -1, 0.5}, core::Vec3{-1, -0.5, 0}})
      rays.push_back({glm::normalize(turned(along)), bodies});
    std::vector<trace::Sample> samples(rays.size());
    trace::Counts counts;
    trace::Tracer(world).trace(rays, samples, counts);
    INFO("seed 32, block " << i);
    CHECK(samples[0].radiance == core::Color{1});
    CHECK(samples[1].radiance == core::Color{1});
    CHECK(samples[2].radiance != core::Color{1});
  }
}

namespace {

/// Of scenes of several kinds, among them axis-parallel rays, an eye on an object, a light on a surface.
scene::World searched_world(std::uint64_t seed, int most_objects) {
  test::RandomScene random(seed);
  scene::Scene scene = random.make({.objects = 1 + static_cast<int>(seed % most_objects)});
  if (seed % 4 == 1) scene.camera.eye = {0.5, -9, 1}, scene.camera.target = {0.5, 1, 1};
  if (seed % 4 == 2) scene.camera.eye.z = 0;
  if (seed % 4 == 3) scene.lights[0].position.z = 0;
  return scene::make_world(scene);
}

/// Without candidates: the first hit is searched for as well.
std::vector<trace::EyeRay> rays_without_candidates(const scene::World& world, std::uint64_t seed) {
  std::vector<trace::EyeRay> eye;
  for (const Position& p : random_positions(world, 700, seed))
    eye.push_back({world.camera.direction(p.x, p.y), {}});
  for (int x = 0; x <= world.camera.width; x += 4) // zeros among the directions' coordinates
    eye.push_back({world.camera.direction(x, world.camera.height / 2.0), {}});
  return eye;
}

struct Traced {
  std::vector<trace::Sample> samples;
  trace::Counts counts;
};

Traced traced(const trace::Tracer& tracer, const std::vector<trace::EyeRay>& eye) {
  Traced result{std::vector<trace::Sample>(eye.size()), {}};
  tracer.trace(eye, result.samples, result.counts);
  return result;
}

void require_same(const Traced& a, const Traced& b) {
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    INFO("ray " << k);
    REQUIRE(a.samples[k].radiance == b.samples[k].radiance);
    REQUIRE(a.samples[k].tree == b.samples[k].tree);
    REQUIRE(a.samples[k].first == b.samples[k].first);
    REQUIRE(a.samples[k].rays == b.samples[k].rays);
  }
  CHECK(a.counts.shadow == b.counts.shadow);
}

std::uint64_t rays_of(const trace::Counts& counts) {
  return counts.reflected + counts.refracted + counts.shadow;
}

} // namespace

TEST_CASE("a hierarchy finds what a look at every body finds, bit for bit") {
  std::uint64_t rays = 0;
  for (std::uint64_t seed = 300; seed < 340; ++seed) {
    INFO("seed " << seed);
    const scene::World world = searched_world(seed, 40);
    const std::vector<trace::EyeRay> eye = rays_without_candidates(world, seed);
    const Traced found = traced(trace::Tracer(world, trace::Search::hierarchy), eye);
    require_same(traced(trace::Tracer(world, trace::Search::all), eye), found);
    rays += rays_of(found.counts);
  }
  CHECK(rays > 30'000);
}

TEST_CASE("samples have the same bits with every instruction set") {
  if (core::widest_simd() == core::Simd::baseline) {
    halftone::test::skip_anywhere("the processor has nothing beyond the baseline");
    return;
  }
  std::uint64_t rays = 0;
  for (std::uint64_t seed = 400; seed < 440; ++seed) {
    const scene::World world = searched_world(seed, 20);
    const std::vector<trace::EyeRay> eye = rays_without_candidates(world, seed);
    const Traced scalar = traced(trace::Tracer(world, trace::Search::all, core::Simd::baseline), eye);
    for (const core::Simd simd : {core::Simd::avx2, core::Simd::avx512}) {
      if (simd > core::widest_simd()) continue;
      INFO(core::name(simd) << ", seed " << seed);
      require_same(scalar, traced(trace::Tracer(world, trace::Search::all, simd), eye));
    }
    rays += rays_of(scalar.counts);
  }
  CHECK(rays > 20'000);
}
