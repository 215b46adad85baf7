#pragma once
// Where a point is: over or on a surface, in a solid.

#include <halftone/scene/world.h>

#include <vector>

namespace halftone::geometry {

using core::Vec3;

/// Height of a point over a surface in scene units, negative behind a plane or in a quadric, and a bound of
/// the rounding in it.
struct Height {
  double value = 0;
  double bound = 0;

  /// A point is on a surface where it cannot be told from one that is.
  bool is_on() const { return value <= bound && -value <= bound; }
};

/// Of one of the world's surfaces.
Height height_over(const scene::World& world, const scene::Surface& surface, const Vec3& point);

/// The solids that contain a point, ascending. A point on the surface of a solid is outside.
std::vector<int> solids_around(const scene::World& world, const Vec3& point);

/// The planes among the world's surfaces that a point is on, ascending.
std::vector<int> planes_through(const scene::World& world, const Vec3& point);

/// A surface that a point is on, or -1: of several, a round one before a plane, otherwise the first.
int surface_under(const scene::World& world, const Vec3& point);

} // namespace halftone::geometry
