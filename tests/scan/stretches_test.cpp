#include "stretches.h"
#include "support/random_scene.h"
#include "visibility.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace halftone;

TEST_CASE("shadow intervals tile each visible interval and agree with dense shadow rays") {
  int dark = 0, lit = 0, uncertain = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    test::RandomScene random(seed);
    const scene::World world = scene::make_world(random.make({7, true, seed % 2 == 0, seed % 3 == 0}));
    const scan::Frame frame(world);
    order::Order order(world, frame.hulls);
    shadow::Shadows shadows(world, frame.screen, frame.hulls, frame.casters);
    std::vector<reference::PlacedLight> lights;
    for (const scene::Light& light : world.lights)
      lights.push_back({light, reference::solids_around(world, light.position),
                        reference::polygons_through(world, light.position)});
    for (int line = 0; line < 24; ++line) {
      const double y = random.uniform(0, 48);
      for (const scan::Interval& interval :
           scan::visible_intervals(frame, scan::active_in(frame, y, y), order, y)) {
        if (interval.face < 0 || !interval.candidates.empty()) continue;
        const scan::ScreenFace& face = frame.faces[interval.face];
        const auto parts = scan::stretches(frame, shadows, interval, y);
        REQUIRE(parts.front().left == interval.left);
        REQUIRE(parts.back().right == interval.right);
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) REQUIRE(parts[i].right == parts[i + 1].left);
        for (const scan::Stretch& part : parts)
          for (int k = 0; k < 3; ++k) {
            const double x = part.left + (part.right - part.left) * random.uniform(0.01, 0.99);
            if (std::min(x - part.left, part.right - x) < 1e-6) continue;
            const core::Vec3 direction = frame.screen.direction(x, y);
            const core::Vec3 point = world.camera.eye + direction / face.inverse_depth.at(x, y);
            const scene::Face& own = world.bodies[face.body].faces[face.face];
            const auto& plane = std::get<scene::Plane>(world.surfaces[own.surface]);
            const double facing = glm::dot(plane.normal, direction) > 0 ? -1 : 1;
            for (std::size_t light = 0; light < lights.size(); ++light) {
              const core::Vec3 to_light = world.lights[light].position - point;
              if (facing * glm::dot(plane.normal, to_light) <= 0) continue; // turned away: dark in any case
              // Inside another solid, where no eye but the oracle's looks.
              if (!reference::solids_around(world, point + plane.normal * (facing * 1e-6)).empty()) continue;
              const core::Color seen =
                  reference::visibility(world, lights[light], point, own.surface, face.body);
              const scan::Lighting& lighting = part.lights[light];
              INFO("seed " << seed << " at " << x << ", " << y << ", light " << light << ", body "
                           << face.body);
              if (lighting.dark)
                REQUIRE(seen == core::black);
              else if (lighting.casters.empty())
                REQUIRE(seen == core::Color{1});
              ++(lighting.dark ? dark : lighting.casters.empty() ? lit : uncertain);
            }
          }
      }
    }
  }
  CHECK(dark > 1'000);
  CHECK(lit > 5'000);
  CHECK(uncertain > 500);
}

TEST_CASE("pattern changes lie where the cell number changes") {
  test::RandomScene random(5);
  int found = 0;
  for (int round = 0; round < 60; ++round) {
    scene::Scene built = random.make({0, false, false, false});
    const scene::World world = scene::make_world(built);
    const scan::Frame frame(world);
    const double size = world.materials[1].checker->size;
    for (const scan::ScreenFace& face : frame.faces) {
      const double y = random.uniform(face.top, face.bottom);
      const auto extent = view::extent_at(face.outline, y);
      if (!extent) continue;
      const auto cell_at = [&](double x) {
        const core::Vec3 p = world.camera.eye + frame.screen.direction(x, y) / face.inverse_depth.at(x, y);
        return std::floor(p.x / size) + std::floor(p.y / size);
      };
      const auto changes = scan::pattern_changes(frame, face, y, extent->left, extent->right, 1000);
      REQUIRE(changes);
      double previous = extent->left;
      for (std::size_t i = 0; i <= changes->size(); ++i) {
        const double next = i < changes->size() ? (*changes)[i] : extent->right;
        INFO("round " << round << ", part " << i);
        // One cell from change to change: the same near both ends.
        if (next - previous > 1e-6) REQUIRE(cell_at(previous + 1e-8) == cell_at(next - 1e-8));
        previous = next;
        ++found;
      }
      if (changes->size() > 2)
        CHECK_FALSE(scan::pattern_changes(frame, face, y, extent->left, extent->right, 2));
    }
  }
  CHECK(found > 100);
}
