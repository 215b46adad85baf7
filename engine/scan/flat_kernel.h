#pragma once
// Pixels of a flat face shaded side by side.

#include <halftone/core/simd.h>
#include <halftone/scene/world.h>
#include <halftone/view/screen.h>

#include <span>
#include <vector>

namespace halftone::scan {

/// What all points have in common that are shaded on one flat face under the same lights.
struct FlatTerms {
  scene::CameraFrame camera;
  view::Linear inverse_depth;
  core::Vec3 normal{0}; ///< unit length, towards the eye
  core::Color ambient{0};
  core::Color specular{0};
  double shininess = 0;
  std::vector<scene::Light> lights; ///< that reach the face, which is turned to them
};

/// The radiance of an albedo at positions (x, y), (x + 1, y) and so on of the screen.
using ShadeFlat = void (*)(const FlatTerms& terms, const core::Color& albedo, double x, double y,
                           std::span<core::Color> radiance);

/// For an instruction set that the processor has; nullptr for the baseline, whose code is FlatRun::at().
ShadeFlat shade_flat_with(core::Simd simd);

} // namespace halftone::scan
