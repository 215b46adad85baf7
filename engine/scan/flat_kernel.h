#pragma once
// Points of a flat face shaded side by side.

#include <halftone/core/simd.h>
#include <halftone/scene/world.h>
#include <halftone/view/screen.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace halftone::scan {

/// What all points have in common that are shaded on one flat face under the same lights.
struct FlatTerms {
  const scene::CameraFrame& camera;
  view::Linear inverse_depth;
  core::Vec3 normal{0}; ///< unit length, towards the eye
  core::Color ambient{0};
  core::Color specular{0};
  double shininess = 0;
  std::vector<scene::Light> lights; ///< that reach the face, which is turned to them
};

/// Positions of the screen, and the albedo at each: as many as fill the vectors of every instruction set.
struct FlatPoints {
  static constexpr std::size_t capacity = 32;

  std::array<double, capacity> x{}, y{};
  std::array<core::Color, capacity> albedo{};
  std::size_t count = 0; ///< of those that are meant

  void add(const view::ScreenPoint& at, const core::Color& own) {
    x[count] = at.x;
    y[count] = at.y;
    albedo[count++] = own;
  }
};

/// The radiance at each.
using ShadeFlat = void (*)(const FlatTerms& terms, const FlatPoints& points,
                           std::span<core::Color, FlatPoints::capacity> radiance);

/// For an instruction set that the processor has; nullptr for the baseline, whose code is
/// FlatRun::radiance().
ShadeFlat shade_flat_with(core::Simd simd);

} // namespace halftone::scan
