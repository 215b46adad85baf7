#pragma once
// Lines, and where they cross a body. World space; distances along a line in scene units.

#include <halftone/core/vector.h>

namespace halftone::geometry {

using core::Vec3;

/// A line with an origin and a unit direction. Where it starts on a surface, it meets that surface at t = 0
/// by fact and not by calculation, and `outward` says to which side it leaves. A line that starts at the
/// world's eye meets all planes at t = 0 that the eye is on.
struct Line {
  Vec3 origin{0};
  Vec3 direction{0};
  int surface = -1;     ///< index into World::surfaces, or none
  bool outward = false; ///< to the side of the plane's normal, or out of the quadric
  bool at_eye = false;  ///< the origin is the eye, to the bit

  Vec3 at(double t) const { return origin + direction * t; }
};

/// Where a line crosses a face.
struct Crossing {
  double t = 0;
  int face = -1; ///< index into Body::faces
};

/// The part of a line that lies in a solid.
struct Span {
  Crossing in;
  Crossing out;
};

} // namespace halftone::geometry
