#include "setting.h"

#include <catch2/catch.hpp>

using namespace setting;

namespace {

/// White left of or above a line through the image, black elsewhere; the line is `at` pixels from the left or
/// top.
scene::World half_white(double at, bool left) {
  constexpr double half_image = 256;
  scene::Scene built = of({});
  // At z = 9 the image is 2 tan(fov / 2) high, 1 from the eye.
  built.camera.fov = 90;
  const double edge = at / half_image - 1;
  built.objects.emplace_back();
  built.objects[0].shape = left ? scene::Polygon{{{-5, -5, 9}, {edge, -5, 9}, {edge, 5, 9}, {-5, 5, 9}}}
                                : scene::Polygon{{{-5, -edge, 9}, {5, -edge, 9}, {5, 5, 9}, {-5, 5, 9}}};
  built.materials.push_back(matte(Color{1}));
  built.ambient = Color{1};
  built.background = Color{0};
  return scene::make_world(built);
}

/// Mean of the 256 pixels along the line.
double mean_along(const scene::World& world, bool left, int samples) {
  const halftone::reference::Reference reference(world);
  halftone::reference::Counts counts;
  double sum = 0;
  for (int i = 128; i < 384; ++i)
    sum +=
        reference
            .pixel(left ? 256 : i, left ? i : 256, samples, halftone::reference::Sampling::stratified, counts)
            .r;
  return sum / 256;
}

} // namespace

TEST_CASE("stratified samples fill their cells, so that a pixel's mean is its covered area") {
  // Shares within a cell of one and of two samples a side; 0.1 is three deviations of 256 samples.
  for (const bool left : {true, false})
    for (const int samples : {1, 2})
      for (const double share : {0.2, 0.4, 0.7, 0.9}) {
        INFO((left ? "left " : "above ") << share << " with " << samples << " samples a side");
        CHECK(mean_along(half_white(256 + share, left), left, samples) == Approx(share).margin(0.1));
      }
}
