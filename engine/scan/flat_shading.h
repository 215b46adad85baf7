#pragma once
// The radiance of a face drawn by scanlines at a position of the screen.

#include "stretches.h"

#include <cstdint>
#include <optional>

namespace halftone::scan {

struct FlatSample {
  core::Color radiance{0};
  /// Which lights reach the point, and through what; the cell of its pattern; which way its normal was
  /// turned.
  std::uint64_t signature = 0;
};

/// lights: of the stretch that holds (x, y). Shadow tests are made against its listed casters alone, and
/// counted. albedo: in place of the face's own.
FlatSample shade_flat(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
                      double x, double y, trace::Counts& counts,
                      const std::optional<core::Color>& albedo = std::nullopt);

/// Whether the round normal of a stand-in's face looks away from the eye there, and is turned for shading.
bool is_turned(const Frame& frame, const ScreenFace& face, double x, double y);

} // namespace halftone::scan
