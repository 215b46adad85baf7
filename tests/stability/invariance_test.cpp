#include "support/random_scene.h"
#include "tally.h"

#include <halftone/render/render.h>
#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

// The same picture wherever the scene lies and whichever way it is turned, with its camera: moved by 10^6
// sizes, turned about z, mirrored, its objects in another order. (Scaled by powers of two it has the same
// bits: tests/render.) Scenes without patterns, which lie in the world. The polyhedra about round bodies lie
// with its axes, so pixels are cut and sampled elsewhere: the same within the tolerance of the quality, not
// to the bit.

using namespace halftone;

namespace {

std::vector<core::Color> drawn(const scene::Scene& scene) {
  std::vector<core::Color> radiance;
  render::render(scene, {}, [&](const render::Row& row) {
    radiance.insert(radiance.end(), row.radiance.begin(), row.radiance.end());
  });
  return radiance;
}

template<typename Move>
scene::Scene moved(scene::Scene scene, Move move) {
  scene.camera.eye = move(scene.camera.eye);
  scene.camera.target = move(scene.camera.target);
  for (scene::Light& light : scene.lights) light.position = move(light.position);
  for (scene::Object& object : scene.objects) object.placement.translate = move(object.placement.translate);
  return scene;
}

scene::Scene far_away(const scene::Scene& scene) {
  return moved(scene, [](const core::Vec3& p) { return p + core::Vec3{1e6, -2e6, 1.5e6}; });
}

scene::Scene turned(const scene::Scene& scene, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  scene::Scene result = moved(scene, [&](const core::Vec3& p) {
    return core::Vec3{std::cos(angle) * p.x - std::sin(angle) * p.y,
                      std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
  });
  for (scene::Object& object : result.objects) object.placement.rotate.z += degrees;
  return result;
}

void mirror(scene::Sphere& s) { s.center.x = -s.center.x; }
void mirror(scene::Frustum& f) { f.base.x = -f.base.x, f.top.x = -f.top.x; }
void mirror(scene::Box& b) { b = {{-b.max.x, b.min.y, b.min.z}, {-b.min.x, b.max.y, b.max.z}}; }
void mirror(scene::Prism& p) { p.turn = 180 - p.turn; }
void mirror(scene::Polyhedron& p) {
  for (core::Vec3& v : p.vertices) v.x = -v.x;
}
void mirror(scene::Polygon& p) {
  for (core::Vec3& v : p.vertices) v.x = -v.x;
}

scene::Scene mirrored(const scene::Scene& scene) {
  scene::Scene result = moved(scene, [](const core::Vec3& p) { return core::Vec3{-p.x, p.y, p.z}; });
  for (scene::Object& object : result.objects) {
    object.placement.rotate.y = -object.placement.rotate.y;
    object.placement.rotate.z = -object.placement.rotate.z;
    std::visit([](auto& shape) { mirror(shape); }, object.shape);
  }
  return result;
}

void flip(std::vector<core::Color>& picture, int width) {
  for (auto row = picture.begin(); row != picture.end(); row += width) std::reverse(row, row + width);
}

/// Pixels that are off by more than a level, and the largest difference.
struct Off {
  int pixels = 0;
  double largest = 0;
};

Off difference(const std::vector<core::Color>& a, const std::vector<core::Color>& b,
               const scene::Image& image) {
  Off off;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double most = 0;
    for (int channel = 0; channel < 3; ++channel)
      most = std::max(most, std::abs(shade::display_level(a[i][channel], image) -
                                     shade::display_level(b[i][channel], image)));
    if (!(most <= 1)) ++off.pixels;
    off.largest = std::max(off.largest, most);
  }
  return off;
}

/// Returns how many pixels are off by more than a level.
int compare(std::uint64_t seed, test::Tally& tally) {
  int pixels_off = 0;
  test::RandomScene random(seed);
  scene::Scene scene = random.make({7, true, true, false});
  for (scene::Material& material : scene.materials) material.checker.reset();
  const std::vector<core::Color> wanted = drawn(scene);
  const auto add = [&](const char* what, const std::vector<core::Color>& picture,
                       const std::vector<core::Color>& expected) {
    const Off off = difference(picture, expected, scene.image);
    std::ostringstream which;
    which << "seed " << seed << ", " << what << ": " << off.pixels << " pixels";
    // No pixel by more than a picture may be off by default.
    tally.add(off.largest, !(off.largest < 16), which.str());
    pixels_off += off.pixels;
  };
  add("moved", drawn(far_away(scene)), wanted);
  add("turned", drawn(turned(scene, random.uniform(-180, 180))), wanted);
  std::vector<core::Color> flipped = drawn(mirrored(scene));
  flip(flipped, scene.image.width);
  add("mirrored", flipped, wanted);

  scene::Scene opaque = random.make({7, true, false, false});
  const std::vector<core::Color> in_order = drawn(opaque);
  std::reverse(opaque.objects.begin(), opaque.objects.end());
  add("reversed", drawn(opaque), in_order);
  return pixels_off;
}

/// The share of pixels that are off by more than a level; none may be off by 16.
double invariance(std::uint64_t scenes) {
  double off = 0;
  const test::Tally tally = test::tally_of(
      "invariance", scenes, [&](std::uint64_t seed, test::Tally& cases) { off += compare(seed, cases); });
  const double share = off / static_cast<double>(tally.cases * 64 * 48);
  WARN("off by more than a level: " << share);
  CHECK(tally.failures == 0);
  return share;
}

} // namespace

TEST_CASE("the picture is the same wherever and whichever way round the scene lies") {
  CHECK(invariance(12) < 1e-4);
}

TEST_CASE("the picture is the same wherever the scene lies: many", "[.][long]") {
  CHECK(invariance(1000) < 1e-4);
}
