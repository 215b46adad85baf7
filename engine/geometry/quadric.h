#pragma once
// Where a line is inside a sphere or a cone surface.

#include <halftone/geometry/solids.h>

#include <limits>

namespace halftone::geometry {

/// in > out: nowhere.
struct Range {
  double in = -std::numeric_limits<double>::infinity();
  double out = std::numeric_limits<double>::infinity();
};

inline constexpr Range nowhere{std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};

FramedCone framed(const scene::ConeSurface& cone);

Range range_in(const scene::SphereSurface& sphere, const Line& line);

/// On the nappe whose radius is not negative.
Range range_in(const FramedCone& cone, const Line& line);

/// Of a line that starts on the quadric: one end is 0, and the side to which it leaves says which.
Range started(const Range& range, bool outward);

} // namespace halftone::geometry
