#include "flat_shading.h"
#include "pattern.h"
#include "variation.h"

#include "support/random_scene.h"

#include <catch2/catch.hpp>

using namespace halftone;

namespace {

scene::World flat_world(std::uint64_t seed) {
  test::RandomScene random(seed);
  scene::Scene scene = random.make({.objects = 10, .round = false, .glass = false});
  if (seed % 4 == 0) scene.lights[0].position.z = 0; // in the floor's plane
  return scene::make_world(scene);
}

} // namespace

TEST_CASE("a run is shaded as its points are, to the bit") {
  long compared = 0, dark = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const scene::World world = flat_world(seed);
    const scan::Frame frame(world);
    test::RandomScene random(seed + 1000);
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
      const scan::ScreenFace& face = frame.faces[f];
      std::vector<scan::Lighting> lights(world.lights.size());
      for (scan::Lighting& light : lights) light.dark = random.pick(4) == 0;
      const auto albedo = random.pick(4) == 0 ? std::optional(core::Color{0.3, 0.5, 0.2}) : std::nullopt;
      const scan::FlatRun run(frame, face, lights, albedo);
      for (int k = 0; k < 40; ++k) {
        // In the face or not: its plane is shaded wherever it is seen.
        const double x = random.uniform(0, world.camera.width), y = random.uniform(0, world.camera.height);
        if (!(face.inverse_depth.at(x, y) > 0)) continue;
        trace::Counts counts;
        const scan::FlatSample one = scan::shade_flat(frame, face, lights, x, y, counts, albedo);
        const scan::FlatSample other = run.at(x, y);
        INFO("seed " << seed << ", face " << f << ", at " << x << " " << y);
        REQUIRE(one.radiance == other.radiance);
        REQUIRE(one.signature == other.signature);
        ++compared;
        dark += one.radiance == core::black ? 1 : 0;
      }
    }
  }
  CHECK(compared > 10'000);
  CHECK(dark < compared / 2);
}

TEST_CASE("what a run has not, none of its pixels has") {
  long plain = 0, steady = 0, lined = 0, varying = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const scene::World world = flat_world(seed);
    const scan::Frame frame(world);
    test::RandomScene random(seed + 2000);
    scan::Pieces pieces;
    for (const scan::ScreenFace& face : frame.faces) {
      const std::vector<scan::Lighting> lights(world.lights.size());
      for (int k = 0; k < 10; ++k) {
        const int y = random.pick(world.camera.height), left = random.pick(world.camera.width);
        const scan::PixelRange run{left, std::min(world.camera.width, left + 1 + random.pick(32))};
        const auto is_seen = [&](double x, double at) { return face.inverse_depth.at(x, at) > 0; };
        if (!is_seen(run.begin, y) || !is_seen(run.end, y) || !is_seen(run.begin, y + 1) ||
            !is_seen(run.end, y + 1))
          continue;
        const double missed = random.uniform(0, 0.01);
        const bool has_lines = scan::has_pattern_lines(frame, face, run, y);
        const bool may_vary = scan::may_vary(frame, face, lights, run, y, missed);
        ++(has_lines ? lined : plain);
        ++(may_vary ? varying : steady);
        for (int x = run.begin; x < run.end; ++x) {
          const scan::Piece pixel = pieces.whole(x, y);
          const auto lines = scan::pattern_lines(frame, face, pixel, pieces);
          INFO("seed " << seed << ", pixel " << x << " " << y);
          if (!has_lines) REQUIRE(lines[0].count() + lines[1].count() == 0);
          if (!may_vary) REQUIRE_FALSE(scan::varies(frame, face, lights, pixel, pieces, missed));
        }
      }
    }
  }
  CHECK(plain > 1000);
  CHECK(lined > 100);
  CHECK(steady > 1000);
  CHECK(varying > 100);
}
