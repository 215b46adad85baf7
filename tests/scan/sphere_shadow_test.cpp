#include "sphere_shadow.h"
#include "support/random_scene.h"
#include "visibility.h"

#include <halftone/shadow/shadows.h>

#include <catch2/catch.hpp>

using namespace halftone;

TEST_CASE("a sphere's shadow on a scanline ends where shadow rays begin to miss it") {
  test::RandomScene random(9);
  int exact = 0, missed = 0;
  for (int round = 0; round < 400; ++round) {
    scene::Scene built = random.make({0, false, false, false});
    scene::Object ball;
    ball.shape = scene::Sphere{{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0.2, 2)},
                               random.uniform(0.1, 1.0)};
    built.objects.push_back(ball);
    if (round % 4 == 0) { // just outside the hull or inside it, beside the sphere and above
      const auto& sphere = std::get<scene::Sphere>(ball.shape);
      const core::Vec3 aside{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.2, 1)};
      built.lights[0].position =
          sphere.center + glm::normalize(aside) * (sphere.radius * random.uniform(1.01, 1.3));
    }
    const scene::World world = scene::make_world(built);
    const scan::Frame frame(world);
    shadow::Shadows shadows(world, frame.screen, frame.hulls, frame.casters);
    if (frame.faces.empty()) continue;
    const scan::ScreenFace& floor = frame.faces[0];
    const int surface = world.bodies[0].faces[0].surface;
    for (int light = 0; light < 2; ++light) {
      const scene::Light& source = world.lights[light];
      const reference::PlacedLight placed{source, reference::solids_around(world, source.position), {}};
      for (const shadow::Region& region : shadows.on(0, 0, light)) {
        if (region.anywhere) continue;
        for (int line = 0; line < 8; ++line) {
          const double y = random.uniform(0, 48);
          const auto extent = view::extent_at(region.outline, y);
          if (!extent || !(extent->right - extent->left > 1e-3)) continue;
          const auto found = scan::exact_sphere_shadow(frame, floor, 1, light, y, *extent);
          if (!found) continue;
          CHECK(found->dark);
          const auto is_dark = [&](double x) {
            const core::Vec3 p =
                world.camera.eye + frame.screen.direction(x, y) / floor.inverse_depth.at(x, y);
            return reference::visibility(world, placed, p, surface, 0) == core::black;
          };
          for (int k = 0; k < 20; ++k) {
            const double x = random.uniform(extent->left, extent->right);
            const bool inside = found->extent && x > found->extent->left && x < found->extent->right;
            if (found->extent &&
                std::min(std::abs(x - found->extent->left), std::abs(x - found->extent->right)) < 1e-7)
              continue;
            INFO("round " << round << ", light " << light << " at " << x << ", " << y);
            REQUIRE(is_dark(x) == inside);
            ++(inside ? exact : missed);
          }
        }
      }
    }
  }
  CHECK(exact > 2'000);
  CHECK(missed > 500);
}
