#include "setting.h"

#include <halftone/shade/fresnel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

// Touching solids are separated by an infinitely thin gap, so a scene that touches must look like the same
// scene with a small gap in it: small against all features, large against the distance at which faces
// coincide.

using namespace setting;
using halftone::shade::fresnel_reflectance;

namespace {

constexpr double no_gap = 0, small_gap = 1e-7;

struct Compared {
  double mean = 0;      ///< mean difference of the radiance, largest channel
  double different = 0; ///< share of rays that differ by more than 1e-3
};

/// The same random rays through both scenes, aimed at the middle of things.
Compared compare(const scene::Scene& a, const scene::Scene& b, std::uint64_t seed) {
  const scene::World world_a = scene::make_world(a), world_b = scene::make_world(b);
  const halftone::reference::Reference of_a(world_a), of_b(world_b);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> pixel(0, 512);
  Compared result;
  constexpr int rays = 4'000;
  for (int i = 0; i < rays; ++i) {
    const double x = pixel(random), y = pixel(random);
    halftone::reference::Counts counts;
    const Color difference = glm::abs(of_a.radiance(x, y, counts) - of_b.radiance(x, y, counts));
    const double largest = halftone::core::max_component(difference);
    result.mean += largest / rays;
    result.different += (largest > 1e-3 ? 1.0 : 0.0) / rays;
  }
  return result;
}

scene::Scene lit_and_turned(std::vector<Part> parts, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(-180, 180), shift(-3, 3);
  scene::Scene built = of(std::move(parts));
  built.ambient = Color{0.2};
  built.background = {0.3, 0.4, 0.6};
  built.trace.depth = 8;
  built.trace.cutoff = 1e-3;
  built.camera.eye = {5, -6, 4};
  built.camera.up = {0, 0, 1};
  built.camera.fov = 30;
  built.lights.push_back({{-5, -4, 7}, {0.6, 0.5, 0.4}});
  built.lights.push_back({{6, -1, -2}, {0.3, 0.4, 0.5}});
  const Vec3 turn{angle(random), angle(random), angle(random)};
  for (scene::Object& object : built.objects) object.placement = {1, turn, {0, 0, 0}};
  return built;
}

/// Solids with their base in the plane z = 0, `lift` above it, 1 high.
std::vector<scene::Shape> solids(double lift) {
  return {scene::Box{{-1, -0.8, lift}, {0.9, 1, 1 + lift}},
          scene::Prism{{0, 0, lift}, {0, 0, 1 + lift}, 1.2, 5, 12},
          scene::Frustum{{0.1, 0, lift}, {0.1, 0, 1 + lift}, 0.9, 0.9},
          scene::Frustum{{0, 0, lift}, {0, 0, 1 + lift}, 1, 0.6},
          scene::Frustum{{0, 0.1, lift}, {0, 0.1, 1 + lift}, 1.1, 0}};
}

/// The same below the plane z = 0.
scene::Shape below(const scene::Shape& shape) {
  if (const auto* box = std::get_if<scene::Box>(&shape))
    return scene::Box{{box->min.x, box->min.y, -1}, {box->max.x, box->max.y, 0}};
  if (const auto* prism = std::get_if<scene::Prism>(&shape))
    return scene::Prism{{0, 0, -1}, {0, 0, 0}, prism->radius, prism->sides, prism->turn};
  const auto& frustum = std::get<scene::Frustum>(shape);
  return scene::Frustum{frustum.base, frustum.base - Vec3{0, 0, 1}, frustum.base_radius, frustum.top_radius};
}

scene::Material glossy(scene::Material material) {
  material.specular = Color{0.3};
  return material;
}

} // namespace

TEST_CASE("flush stacks of every pair of solids look like stacks with a gap of 1e-7") {
  const auto materials = [](int k) {
    return k == 0   ? glossy(glass(1.5, {0.1, 0.2, 0.3}))
           : k == 1 ? glossy(glass(1.3))
                    : glossy(matte({0.7, 0.5, 0.3}));
  };
  std::uint64_t seed = 100;
  for (std::size_t lower = 0; lower < solids(0).size(); ++lower)
    for (std::size_t upper = 0; upper < solids(0).size(); ++upper)
      for (const auto& pair : {std::pair{0, 1}, std::pair{0, 2}, std::pair{2, 0}}) {
        const int m = pair.first, n = pair.second; // clang 14 captures no structured bindings
        ++seed;
        const auto stack = [&](double gap) {
          return lit_and_turned({{below(solids(0)[lower]), materials(m)}, {solids(gap)[upper], materials(n)}},
                                seed);
        };
        const Compared result = compare(stack(no_gap), stack(small_gap), seed);
        INFO("seed " << seed << ", lower " << lower << ", upper " << upper << ", materials " << m << n);
        CHECK(result.mean < 1e-4);
        CHECK(result.different < 2e-3);
      }
}

TEST_CASE("a polygon under glass, on glass and between two glasses looks like one with gaps around it") {
  std::uint64_t seed = 500;
  for (std::size_t shape = 0; shape < solids(0).size(); ++shape)
    for (const double reflectance : {0.0, 0.6}) {
      ++seed;
      const auto sandwich = [&](double gap) {
        scene::Material sheet = matte({0.7, 0.5, 0.3});
        sheet.mirror = Color{reflectance};
        return lit_and_turned({{square_at(0, 1.3), sheet},
                               {solids(gap)[shape], glossy(glass(1.5, {0.1, 0.2, 0.3}))},
                               {scene::Box{{-0.7, -0.7, -1}, {0.7, 0.7, -gap}}, glossy(glass(1.4))}},
                              seed);
      };
      const Compared result = compare(sandwich(no_gap), sandwich(small_gap), seed);
      INFO("seed " << seed << ", shape " << shape << ", mirror " << reflectance);
      CHECK(result.mean < 1e-4);
      CHECK(result.different < 2e-3);
    }
}

TEST_CASE("water that fills a tumbler to its wall looks like water that reaches a little into it") {
  // Outer glass, a hole of air in it, water in the hole: sides and floor of water and hole coincide.
  const auto tumbler = [](double overlap, std::uint64_t seed) {
    return lit_and_turned({{scene::Frustum{{0, 0, -1}, {0, 0, 1}, 1, 1}, glossy(glass(1.5))},
                           {scene::Frustum{{0, 0, -0.8}, {0, 0, 1}, 0.8, 0.8}, glass(1)},
                           {scene::Frustum{{0, 0, -0.8 - overlap}, {0, 0, 0.4}, 0.8 + overlap, 0.8 + overlap},
                            glossy(glass(1.33, {0.5, 0.2, 0.1}))}},
                          seed);
  };
  for (std::uint64_t seed = 900; seed < 910; ++seed) {
    const Compared result = compare(tumbler(no_gap, seed), tumbler(small_gap, seed), seed);
    INFO("seed " << seed);
    CHECK(result.mean < 1e-4);
    CHECK(result.different < 2e-3);
  }
}

TEST_CASE("two touching plates pass what two plates with a gap pass, with all reflections in the gap") {
  const double r = fresnel_reflectance(1, 1, 1.5);
  // Four boundaries of reflectance r, incoherent: 1 / T - 1 = sum of r / (1 - r) over all of them.
  const double passed = 1 / (1 + 4 * r / (1 - r));
  scene::Scene plates = of({{scene::Box{{-1, -1, 0}, {1, 1, 1}}, glass(1.5)},
                            {scene::Box{{-1, -1, 1}, {1, 1, 2}}, glass(1.5)},
                            {square_at(-3), matte(Color{1})}});
  plates.ambient = Color{1};
  plates.background = Color{0};
  CHECK(seen_from_above(plates).r == Approx(passed).epsilon(1e-9));
}

TEST_CASE("coinciding surfaces of solids that overlap are one boundary") {
  // Two equal blocks: nothing is seen but one block of the last in the file.
  const scene::Box block{{-1, -1, 0}, {1, 1, 1}};
  const scene::Scene once = of({{block, glass(1.5, {1, 0, 0})}});
  const scene::Scene twice = of({{block, glass(1.2, {0, 1, 0})}, {block, glass(1.5, {1, 0, 0})}});
  CHECK(seen_from_above(twice) == seen_from_above(once));
}

TEST_CASE("total reflection inside a solid does not see what touches it from outside") {
  // A prism of glass, looked into through its top face at more than the critical angle for its side, which a
  // black block touches: the side mirrors the white background below.
  scene::Scene built = of({{scene::Box{{-1, -1, -1}, {1, 1, 1}}, glass(1.5)},
                           {scene::Box{{1, -1, -1}, {3, 1, 1}}, matte(Color{0})}});
  const Vec3 target{0.9, 0, 1}; // refracted to about 35 degrees from the vertical, 55 degrees on the side
  const Color with_block = seen(built, target + Vec3{-2, 0, 1.2}, target);
  built.objects.pop_back();
  const Color without_block = seen(built, target + Vec3{-2, 0, 1.2}, target);
  CHECK(without_block.r > 0.9);
  // What is left of the difference is the little that leaves by the far faces and meets the block elsewhere.
  CHECK(with_block.r == Approx(without_block.r).margin(0.05));
}
