#pragma once
// A line cut by a body: where it is inside. Every solid is convex, so that is one interval.

#include <halftone/scene/world.h>

#include <optional>

namespace halftone::reference {

using core::Vec3;
using scene::Body;
using scene::World;

/// A line with an origin and a unit direction. Where it starts on a surface, that surface is met at t = 0 by
/// fact and not by calculation, and `outward` says to which side the line leaves it.
struct Line {
  Vec3 origin{0};
  Vec3 direction{0};
  int surface = -1;     ///< index into World::surfaces, or none
  bool outward = false; ///< to the side of the plane's normal, or out of the quadric
  bool at_eye = false;  ///< the origin is the eye, so planes that the eye is on are met at t = 0 by fact too

  Vec3 at(double t) const { return origin + direction * t; }
};

/// Where a line crosses a face, t in scene units.
struct Crossing {
  double t = 0;
  int face = -1; ///< index into Body::faces
};

struct Span {
  Crossing in;
  Crossing out;
};

/// The part of the whole line that lies in a solid; in.t < out.t.
std::optional<Span> cut(const World& world, const Body& solid, const Line& line);

/// Where a line that is inside the solid, as a fact, leaves it: t >= 0 whatever rounding says.
Crossing exit(const World& world, const Body& solid, const Line& line);

/// Where a line with t > 0 crosses a polygon that it does not start on.
std::optional<Crossing> cross(const World& world, const Body& polygon, const Line& line);

/// Height of a point over a surface, and a bound of the rounding in it: negative behind a plane or in a
/// quadric. A point is on a surface where the height is within the bound.
struct Height {
  double value = 0;
  double bound = 0;
};
Height height_over(const World& world, const scene::Surface& surface, const Vec3& point);

/// Whether the point is inside the solid. On the surface, or within rounding of it, is outside.
bool contains(const World& world, const Body& solid, const Vec3& point);

} // namespace halftone::reference
