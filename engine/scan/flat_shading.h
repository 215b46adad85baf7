#pragma once
// The radiance of a face drawn by scanlines at a position of the screen.

#include "stretches.h"

#include <cstdint>

namespace halftone::scan {

struct FlatSample {
  core::Color radiance{0};
  std::uint64_t signature =
      0; ///< which lights reach the point, and through what; which way its normal was turned
};

/// lights: of the stretch that holds (x, y). Shadow tests are made against its listed casters alone, and
/// counted.
FlatSample shade_flat(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
                      double x, double y, trace::Counts& counts);

} // namespace halftone::scan
