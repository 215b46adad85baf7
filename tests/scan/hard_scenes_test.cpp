#include "support/effort.h"
#include "support/random_scene.h"

#include <halftone/reference/reference.h>
#include <halftone/scan/band_scanner.h>
#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

// Default rows against the brute-force renderer where they could go wrong.

using namespace halftone;

namespace {

struct Difference {
  double rmse = 0; ///< in levels that are not rounded
  double largest = 0;
};

/// On every `step`-th pixel of every `step`-th row.
Difference against_reference(const scene::World& world, int step, int samples) {
  const scan::Frame frame(world);
  scan::BandScanner scanner(frame, 0.25);
  const reference::Reference reference(world);
  reference::Counts counts;
  Difference difference;
  int channels = 0;
  for (int top = 0; top < world.camera.height; top += 32) {
    const auto band = scanner.scan({top, std::min(32, world.camera.height - top)});
    for (int y = top; y < top + static_cast<int>(band.size()); ++y)
      for (int x = 0; x < world.camera.width; ++x) {
        if (x % step != 0 || y % step != 0) continue;
        const core::Color wanted = reference.pixel(x, y, samples, reference::Sampling::stratified, counts);
        for (int channel = 0; channel < 3; ++channel, ++channels) {
          const double off = shade::display_level(band[y - top].radiance[x][channel], world.image) -
                             shade::display_level(wanted[channel], world.image);
          difference.rmse += off * off;
          difference.largest = std::max(difference.largest, std::abs(off));
        }
      }
  }
  difference.rmse = std::sqrt(difference.rmse / channels);
  return difference;
}

scene::Scene empty_scene(int width, int height) {
  scene::Scene built;
  built.image.width = width;
  built.image.height = height;
  built.materials.resize(1);
  return built;
}

void add(scene::Scene& scene, scene::Shape shape, int material = 0) {
  scene::Object object;
  object.shape = std::move(shape);
  object.material = material;
  scene.objects.push_back(std::move(object));
}

scene::Polygon square(double x, double y, double width, double height, double z) {
  return {{{x, y, z}, {x + width, y, z}, {x + width, y + height, z}, {x, y + height, z}}};
}

} // namespace

TEST_CASE("random scenes of all things are what the reference shows, pixel by pixel") {
  for (std::uint64_t seed = 1; seed <= 30; seed += test::seed_step) {
    test::RandomScene random(seed);
    const scene::World world = scene::make_world(random.make({8, true, true, seed % 3 == 0, seed % 4 == 0}));
    const Difference difference = against_reference(world, 3, 20);
    INFO("seed " << seed << ": rmse " << difference.rmse << ", largest " << difference.largest);
    CHECK(difference.rmse < 0.6); // both sample
    CHECK(difference.largest < 16);
  }
}

TEST_CASE("things half a pixel wide behind a pane are seen in every row") {
  scene::Scene built = empty_scene(64, 96);
  built.camera = {{0, -8, 0}, {0, 0, 0}, {0, 0, 1}, 40};
  built.background = core::Color{0.02};
  built.ambient = core::Color{1};
  built.materials.resize(2);
  built.materials[0].diffuse = core::Color{1};
  built.materials[1].glass = scene::Glass{1.3, core::Color{0}};
  add(built, scene::Box{{-5, -1, -5}, {5, -0.9, 5}}, 1);
  const double bottoms[] = {-1.72, -1.2, -0.25, -0.1, 1.05, 1.3},
               tops[] = {-1.48, -0.8, -0.55, 0.5, 0.55, 1.5};
  for (int k = 0; k < 6; ++k) {
    const double low = bottoms[k], high = tops[k];
    add(built, scene::Polygon{{{low, 1, -4}, {low + 0.03, 1, -4}, {high + 0.03, 1, 4}, {high, 1, 4}}});
  }
  const Difference difference = against_reference(scene::make_world(built), 1, 12);
  INFO("rmse " << difference.rmse << ", largest " << difference.largest);
  CHECK(difference.rmse < 2);     // it was 10.0 where bands lost them,
  CHECK(difference.largest < 32); // and 143
}

TEST_CASE(
    "light that varies within a pixel is integrated: a lamp close to a floor, and one far out over it") {
  scene::Scene built = empty_scene(64, 64);
  built.camera = {{0, -6, 4}, {0, 0, 0}, {0, 0, 1}, 40};
  built.ambient = core::Color{0.05};
  built.lights.push_back({{0.1, 0.2, 0.02}, core::Color{1}});
  add(built, scene::Box{{-5, -5, -1}, {5, 5, 0}});
  const Difference near = against_reference(scene::make_world(built), 1, 24);
  INFO("near: rmse " << near.rmse << ", largest " << near.largest);
  CHECK(near.largest < 1); // it was 11

  built = empty_scene(96, 64);
  built.camera = {{0, -6, 1}, {0, 0, 0.6}, {0, 0, 1}, 40};
  built.background = {0.2, 0.4, 0.8};
  built.ambient = core::Color{0.1};
  built.lights.push_back({{-3, 300, 20}, core::Color{6}});
  add(built, scene::Polygon{{{-1e4, -100, 0}, {1e4, -100, 0}, {1e4, 1e4, 0}, {-1e4, 1e4, 0}}});
  add(built, scene::Box{{-3, 200, 0}, {3, 206, 300}});
  const Difference far = against_reference(scene::make_world(built), 1, 32);
  INFO("far: rmse " << far.rmse << ", largest " << far.largest);
  CHECK(far.rmse < 0.3);
  CHECK(far.largest < 6); // it was 36; the reference samples, too
}

TEST_CASE("a pixel has no more parts for the light in it the more pieces there are") {
  scene::Scene built = empty_scene(1, 1);
  built.camera = {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90};
  built.lights.push_back({{0, 0, 0.01}, core::Color{1e60}}); // never smooth enough
  const auto samples = [&](int strips) {
    built.objects.clear();
    for (int k = 0; k < strips; ++k) add(built, square(-1 + 2.0 * k / strips, -1, 1.5 / strips, 2, 0));
    const scene::World world = scene::make_world(built);
    const scan::Frame frame(world);
    scan::BandScanner scanner(frame, 0.25);
    scanner.scan({0, 1});
    return scanner.counts.samples;
  };
  CHECK(samples(1) > 5'000);
  CHECK(samples(40) < 4 << 14); // it was 40 times as many as for one
}

TEST_CASE("a pattern too fine to be cut lies under the shadow of glass like any other") {
  const auto built = [](double size) {
    scene::Scene scene = empty_scene(48, 32);
    scene.camera = {{0, -6, 3}, {0, 0, 0}, {0, 0, 1}, 40};
    scene.ambient = core::Color{0.1};
    scene.lights.push_back({{-2, -3, 8}, core::Color{1}});
    scene.materials.resize(2);
    scene.materials[0].diffuse = core::Color{0.9};
    if (size > 0)
      scene.materials[0].checker = scene::Checker{core::Color{0.05}, size, 0, 1};
    else
      scene.materials[0].diffuse = core::Color{(0.9 + 0.05) / 2};
    scene.materials[1].glass = scene::Glass{1.5, core::Color{0}};
    add(scene, square(-10, -10, 20, 20, 0));
    add(scene, scene::Sphere{{-1, -1.5, 4}, 0.5}, 1);
    return scene;
  };
  // A pattern that fine is its mean.
  const scene::World fine = scene::make_world(built(1e-5)), plain = scene::make_world(built(0));
  const scan::Frame fine_frame(fine), plain_frame(plain);
  scan::BandScanner fine_scanner(fine_frame, 0.25), plain_scanner(plain_frame, 0.25);
  double most = 0;
  const auto ours = fine_scanner.scan({0, 32}), wanted = plain_scanner.scan({0, 32});
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 48; ++x) {
      most = std::max(most, core::max_component(glm::abs(ours[y].radiance[x] - wanted[y].radiance[x])));
      CHECK((ours[y].notes[x].signature != 0) == (wanted[y].notes[x].signature != 0));
    }
  CHECK(most < 1e-9);
}

TEST_CASE("a pattern finer than coordinates can tell is drawn as its mean") {
  // Its cells have numbers that do not change when 1 is added: they were once counted for ever.
  scene::Scene built = empty_scene(4, 3);
  built.camera = {{1, 1, 1}, {1, 1, 0}, {0, 1, 0}, 1e-20};
  built.ambient = core::Color{1};
  built.materials[0].diffuse = core::Color{0.6};
  built.materials[0].checker = scene::Checker{core::Color{0.2}, 0x1p-60, 0, 1};
  add(built, square(0, 0, 2, 2, 0));
  const scene::World world = scene::make_world(built);
  const scan::Frame frame(world);
  scan::BandScanner scanner(frame, 0.25);
  for (const scan::Row& row : scanner.scan({0, 3}))
    for (const core::Color& radiance : row.radiance) CHECK(std::abs(radiance.r - 0.4) < 1e-12);
}

TEST_CASE("rays on the border of what fills a pixel see what lies behind it, whatever rounding says") {
  scene::Scene built = empty_scene(16, 16);
  built.camera = {
      {0.123, 0.777, 8}, {0.123, 0.777, 0}, {0, 1, 0}, 53.13010235415598}; // a unit is a pixel at z = 0
  built.background = core::Color{40};
  built.ambient = core::Color{0.02};
  built.materials.resize(2);
  built.materials[0].diffuse = core::Color{0.3};
  built.materials[1].diffuse = core::Color{0.1};
  built.materials[1].mirror = core::Color{0.01};
  add(built, square(-8.977, -8.523, 18, 18, -0.5));
  add(built, square(-1.377, -0.723, 2.5, 3.5, 0), 1);
  add(built, square(2.123, -1.723, 1, 5, 0), 1);
  const Difference difference = against_reference(scene::make_world(built), 1, 16);
  INFO("rmse " << difference.rmse << ", largest " << difference.largest);
  CHECK(difference.largest < 2); // it was 85
}

TEST_CASE(
    "sixty lights over thirty boxes are drawn") { // sets of lights were once compared all with all: hours
  scene::Scene built = empty_scene(64, 48);
  built.camera = {{0, -8, 6}, {0, 0, 0}, {0, 0, 1}, 50};
  test::RandomScene random(3);
  add(built, square(-6, -6, 12, 12, 0));
  for (int k = 0; k < 30; ++k) {
    const core::Vec3 at{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(0.2, 1.5)};
    add(built, scene::Box{at, at + core::Vec3{0.4}});
  }
  for (int k = 0; k < 60; ++k)
    built.lights.push_back(
        {{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(3, 9)}, core::Color{0.02}});
  const Difference difference = against_reference(scene::make_world(built), 5, 24);
  INFO("rmse " << difference.rmse << ", largest " << difference.largest);
  CHECK(difference.largest < 2);
}
