#pragma once
// Rays of a queue, and what they know of the place where they start.

#include <halftone/geometry/line.h>

#include <span>
#include <vector>

namespace halftone::trace {

using core::Color;
using core::Vec3;

/// A face of a body.
struct Met {
  int body = -1;
  int face = -1;
};

/// What touches a surface from one side, as a ray in the gap on the surface meets it at distance zero.
struct Touching {
  Met opaque;    ///< the opaque surface that is seen there; body < 0: none
  int first = 0; ///< of the call's Mets: the glass solids that begin there
  int count = 0;
};

/// The glass solids of all gaps that rays are in, or come to.
using Mets = std::vector<Met>;

inline std::span<const Met> entries(const Mets& mets, const Touching& touching) {
  return {mets.data() + touching.first, static_cast<std::size_t>(touching.count)};
}

/// The gap on a surface where solids touch, as a ray in it that goes to one side finds it.
struct Gap {
  Touching ahead;
  Touching behind;
};

struct Ray {
  Vec3 origin;
  Vec3 direction; ///< unit length
  Color weight;
  int surface; ///< that it starts on, or -1
  bool outward;
  bool in_gap;
  bool at_eye; ///< Line::at_eye
  int inside;  ///< a set of InsideSets
  int sample;
  Gap gap; ///< where in_gap

  geometry::Line line() const { return {origin, direction, surface, outward, at_eye}; }
};

} // namespace halftone::trace
