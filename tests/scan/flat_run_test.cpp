#include "flat_shading.h"
#include "pattern.h"
#include "variation.h"

#include "support/random_scene.h"
#include "support/skip.h"

#include <halftone/core/simd.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace halftone;

namespace {

scene::World flat_world(std::uint64_t seed) {
  test::RandomScene random(seed);
  scene::Scene scene = random.make({.objects = 10, .round = false, .glass = false});
  if (seed % 4 == 0) scene.lights[0].position.z = 0; // in the floor's plane
  return scene::make_world(scene);
}

scan::FlatSample sample_at(const scan::FlatRun& run, double x, double y) {
  const auto [albedo, signature] = run.reflecting({x, y});
  scan::FlatPoints points;
  points.add({x, y}, albedo);
  std::array<core::Color, scan::FlatPoints::capacity> radiance;
  run.shade(points, radiance);
  return {radiance[0], signature};
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
        const scan::FlatSample other = sample_at(run, x, y);
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

TEST_CASE("points of a face side by side are as one by one to the bit") {
  if (core::widest_simd() == core::Simd::baseline) {
    test::skip_anywhere("the processor has no instruction set beyond the baseline");
    return;
  }
  long compared = 0, shining = 0;
  for (const core::Simd simd : {core::Simd::avx2, core::Simd::avx512}) {
    if (simd > core::widest_simd()) continue; // same_bits_test says so
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      scene::World world = flat_world(seed);
      test::RandomScene random(seed + 3000);
      for (scene::Material& material : world.materials) {
        const std::array<double, 6> sharpness{0, 1e-3, 1, 20, 500, 1e60};
        material.shininess = sharpness[random.pick(6)];
        if (random.pick(2) == 0) material.specular = core::Color{0.5, 0.25, 0.1};
      }
      const scan::Frame frame(world, core::sagitta, simd);
      const scan::Frame plain_frame(world, core::sagitta, core::Simd::baseline);
      for (const scan::ScreenFace& face : frame.faces) {
        std::vector<scan::Lighting> lights(world.lights.size());
        for (scan::Lighting& light : lights) light.dark = random.pick(4) == 0;
        const scan::FlatRun run(frame, face, lights, std::nullopt);
        const int y = random.pick(world.camera.height), left = random.pick(world.camera.width);
        const scan::PixelRange pixels{left, std::min(world.camera.width, left + 1 + random.pick(32))};
        if (!(face.inverse_depth.at(pixels.begin + 0.5, y + 0.5) > 0) ||
            !(face.inverse_depth.at(pixels.end - 0.5, y + 0.5) > 0))
          continue;
        const scan::FlatRun scalar(plain_frame, face, lights, std::nullopt);
        scan::FlatPoints points;
        for (int x = pixels.begin; x < pixels.end; ++x) {
          const double at_x = x + random.uniform(0, 1), at_y = y + random.uniform(0, 1);
          points.add({at_x, at_y}, run.reflecting({at_x, at_y}).albedo);
        }
        std::array<core::Color, scan::FlatPoints::capacity> radiance, expected;
        run.shade(points, radiance);
        scalar.shade(points, expected);
        for (std::size_t k = 0; k < points.count; ++k) {
          INFO("seed " << seed << ", " << core::name(simd) << ", at " << points.x[k] << " " << points.y[k]);
          REQUIRE(radiance[k] == expected[k]);
          ++compared;
          shining += world.materials[world.bodies[face.body].material].specular != core::black ? 1 : 0;
        }
      }
    }
  }
  CHECK(compared > 5'000);
  CHECK(shining > compared / 4);
}

TEST_CASE("cosines beyond their range are the same side by side") {
  if (core::widest_simd() == core::Simd::baseline) {
    test::skip_anywhere("the processor has no instruction set beyond the baseline");
    return;
  }
  // A light that is mirrored to the eye at a point, or lies hardly over its plane: rounding takes the cosine
  // of the highlight beyond 1, and that of the light below 0; both are multiplied by 1e60.
  long beyond_one = 0, below_nought = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    test::RandomScene random(seed + 4000);
    scene::World world = flat_world(seed % 30 + 1);
    const scan::Frame first(world);
    const scan::ScreenFace& face = first.faces[random.pick(static_cast<int>(first.faces.size()))];
    const bool grazes = seed % 2 == 0;
    view::ScreenPoint at{random.uniform(0, world.camera.width), random.uniform(0, world.camera.height)};
    const view::Linear& near = face.inverse_depth;
    if (!(near.at(at.x, at.y) > 0) || (grazes && near.b == 0)) continue;
    // Far away, where a point is off its plane by more than a light that is said to lie over it may be.
    if (grazes) at.y -= (1 - std::exp2(random.uniform(-24, -12))) * near.at(at.x, at.y) / near.b;
    if (!(near.at(at.x, at.y) > 0)) continue;
    const scene::Body& body = world.bodies[face.body];
    const auto& plane = std::get<scene::Plane>(world.surfaces[body.faces[face.face].surface]);
    const core::Vec3 direction = first.screen.direction(at.x, at.y);
    const core::Vec3 point = world.camera.eye + direction / face.inverse_depth.at(at.x, at.y);
    const core::Vec3 view = glm::normalize(direction);
    const core::Vec3 normal = glm::dot(plane.normal, view) > 0 ? -plane.normal : plane.normal;
    const core::Vec3 mirrored = view - normal * (2 * glm::dot(normal, view));
    const core::Vec3 foot =
        world.camera.eye - plane.normal * (glm::dot(plane.normal, world.camera.eye) - plane.offset);
    world.lights[0].position = grazes ? foot + normal * std::exp2(random.uniform(-48, -24))
                                      : point + random.uniform(1, 9) * mirrored;
    world.lights[0].color = core::Color{1e60};
    scene::Material& material = world.materials[body.material];
    material.specular = core::Color{0.5};
    material.shininess = grazes ? 3 : 1e60;

    const core::Vec3 l = glm::normalize(world.lights[0].position - point);
    const double n_l = glm::dot(normal, l);
    beyond_one += -glm::dot(normal * (2 * n_l) - l, view) > 1 ? 1 : 0;
    const scan::Frame plain_frame(world, core::sagitta, core::Simd::baseline);
    // Only a light that is over the plane, and not in it, is asked for its cosine.
    const auto height = [&](const core::Vec3& p) { return glm::dot(plane.normal, p) - plane.offset; };
    const std::vector<int>& planes = plain_frame.light_planes[0];
    const int surface = body.faces[face.face].surface;
    const bool is_over = (height(world.camera.eye) > 0) == (height(world.lights[0].position) > 0) &&
                         !std::binary_search(planes.begin(), planes.end(), surface);
    below_nought += n_l < 0 && is_over ? 1 : 0;
    const std::vector<scan::Lighting> lights(world.lights.size());
    const scan::FlatRun scalar(plain_frame, face, lights, std::nullopt);
    for (const core::Simd simd : {core::Simd::avx2, core::Simd::avx512}) {
      if (simd > core::widest_simd()) continue;
      const scan::Frame frame(world, core::sagitta, simd);
      const scan::FlatRun run(frame, face, lights, std::nullopt);
      INFO("seed " << seed << ", " << core::name(simd));
      REQUIRE(sample_at(run, at.x, at.y).radiance == sample_at(scalar, at.x, at.y).radiance);
    }
  }
  CHECK(beyond_one > 10);
  CHECK(below_nought > 10);
}

TEST_CASE("what a run has not, none of its pixels has") {
  long plain = 0, steady = 0, lined = 0, varying = 0, pieces_steady = 0;
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
        const bool may_vary = scan::may_vary(frame, face, lights, run, y, missed, scan::Within::pixels);
        ++(has_lines ? lined : plain);
        ++(may_vary ? varying : steady);
        // The least with which pieces are promised to be steady: a bound that is too small shows there.
        const auto pieces_may_vary = [&](double allowed) {
          return scan::may_vary(frame, face, lights, run, y, allowed, scan::Within::pieces);
        };
        double below = 0, promised = 1;
        for (int halving = 0; halving < 40; ++halving)
          (pieces_may_vary((below + promised) / 2) ? below : promised) = (below + promised) / 2;
        const bool is_promised = !pieces_may_vary(promised);
        pieces_steady += is_promised ? 1 : 0;
        for (int x = run.begin; x < run.end; ++x) {
          const scan::Piece pixel = pieces.whole(x, y);
          const auto lines = scan::pattern_lines(frame, face, pixel, pieces);
          INFO("seed " << seed << ", pixel " << x << " " << y);
          if (!has_lines) REQUIRE(lines[0].count() + lines[1].count() == 0);
          if (!may_vary) REQUIRE_FALSE(scan::varies(frame, face, lights, pixel, pieces, missed));
          if (!is_promised) continue;
          REQUIRE_FALSE(scan::varies(frame, face, lights, pixel, pieces, promised));
          scan::Piece piece = pixel;
          for (int cut = 0; cut < 4; ++cut) {
            const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
            const scan::Sides sides = pieces.cut(
                piece, view::Linear{a, b, -a * (x + random.uniform(0, 1)) - b * (y + random.uniform(0, 1))});
            if (sides.inside.count > 0) piece = sides.inside;
            REQUIRE_FALSE(scan::varies(frame, face, lights, piece, pieces, promised));
          }
        }
      }
    }
  }
  CHECK(plain > 1000);
  CHECK(lined > 100);
  CHECK(steady > 1000);
  CHECK(varying > 100);
  CHECK(pieces_steady > 1000);
}
