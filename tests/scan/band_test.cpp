#include "support/effort.h"
#include "support/random_scene.h"

#include <halftone/reference/reference.h>
#include <halftone/scan/band_scanner.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace halftone;

namespace {

std::vector<scan::Row> all_rows(const scan::Frame& frame, scan::BandScanner& scanner) {
  std::vector<scan::Row> rows;
  for (int top = 0; top < frame.world.camera.height; top += 32)
    for (scan::Row& row : scanner.scan({top, std::min(32, frame.world.camera.height - top)}))
      rows.push_back(std::move(row));
  return rows;
}

/// A floor and boxes on it; boxes beneath it, of which nothing can be seen.
scene::Scene boxes_on_a_floor(int hidden) {
  test::RandomScene random(5);
  scene::Scene built;
  built.image.width = 64;
  built.image.height = 48;
  built.camera = {{0.3, -6, 3}, {0, 0, 0.5}, {0, 0, 1}, 40};
  built.ambient = core::Color{0.2};
  built.lights.push_back({{-4, -5, 8}, core::Color{0.8}});
  built.materials.resize(1);
  const auto add = [&](scene::Shape shape) {
    scene::Object object;
    object.shape = std::move(shape);
    built.objects.push_back(std::move(object));
  };
  add(scene::Polygon{{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}});
  for (int k = 0; k < 4; ++k) add(scene::Box{{k - 2.0, 0, 0}, {k - 1.4, 0.7, 0.5 + 0.3 * k}});
  for (int k = 0; k < hidden; ++k) {
    const core::Vec3 at{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-3, -1)};
    add(scene::Box{at, at + core::Vec3{0.2}});
  }
  return built;
}

} // namespace

TEST_CASE("exact rows and 64 virtual scanlines show the same random scenes of flat things") {
  for (std::uint64_t seed = 1; seed <= 40; seed += test::seed_step) {
    test::RandomScene random(seed);
    const scene::World world = scene::make_world(random.make({10, false, false, false, seed % 2 == 0}));
    const scan::Frame frame(world);
    scan::BandScanner exact(frame, 0.25);
    scan::Scanner plain(frame);
    const std::vector<scan::Row> rows = all_rows(frame, exact);
    double sum = 0;
    for (int y = 0; y < world.camera.height; ++y) {
      const scan::Row wanted = plain.scan(y, 64);
      for (int x = 0; x < world.camera.width; ++x) {
        const core::Color off = 255.0 * (rows[y].radiance[x] - wanted.radiance[x]);
        sum += glm::dot(off, off) / 3;
      }
    }
    const double rmse = std::sqrt(sum / (world.camera.width * world.camera.height));
    INFO("seed " << seed << ": rmse " << rmse);
    CHECK(rmse <
          0.5); // of the plain method with 64 lines, whose error falls with the power 1.5 of their number
    CHECK(exact.counts.rays.eye == 0);
  }
}

TEST_CASE("a thousand boxes beneath the floor change no bit and are neither scanned nor asked for shadows") {
  const scene::World without = scene::make_world(boxes_on_a_floor(0)),
                     with = scene::make_world(boxes_on_a_floor(1000));
  const scan::Frame frame(without), hiding(with);
  CHECK(hiding.faces.size() == frame.faces.size());
  CHECK(hiding.casters == frame.casters);
  scan::BandScanner scanner(frame, 0.25), other(hiding, 0.25);
  const std::vector<scan::Row> rows = all_rows(frame, scanner), others = all_rows(hiding, other);
  for (std::size_t y = 0; y < rows.size(); ++y) CHECK(rows[y].radiance == others[y].radiance);
}

TEST_CASE(
    "a highlight of any sharpness is within a level of the reference, where a pixel is wider than it too") {
  for (const double shininess : {30.0, 1e3, 2e4, 1e6}) {
    scene::Scene built;
    built.image.width = 64;
    built.image.height = 48;
    built.camera = {{0, -8, 3}, {0, 0, 0}, {0, 0, 1}, 40};
    built.lights.push_back({{0.03, 8, 3}, core::Color{0.4}});
    built.materials.resize(1);
    built.materials[0].diffuse = core::Color{0.2};
    built.materials[0].specular = core::Color{1};
    built.materials[0].shininess = shininess;
    built.objects.resize(1);
    built.objects[0].shape = scene::Polygon{{{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}}};
    const scene::World world = scene::make_world(built);
    const scan::Frame frame(world);
    scan::BandScanner scanner(frame, 0.25);
    const std::vector<scan::Row> rows = all_rows(frame, scanner);
    const reference::Reference reference(world);
    reference::Counts counts;
    double peak = 0;
    for (int y = 20; y < 28; ++y)
      for (int x = 26; x < 38; ++x) {
        const double wanted = reference.pixel(x, y, 48, reference::Sampling::centred, counts).g;
        peak = std::max(peak, wanted);
        INFO("shininess " << shininess << ", pixel " << x << ' ' << y << ": " << rows[y].radiance[x].g
                          << ", reference " << wanted);
        CHECK(std::abs(rows[y].radiance[x].g - wanted) < 1.0 / 255);
      }
    CHECK(peak > 1.1 * reference.pixel(2, 40, 48, reference::Sampling::centred, counts).g); // it is in there
    CHECK(scanner.counts.rays.eye == 0);
  }
}
