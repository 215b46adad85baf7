#pragma once
// The cone of directions from a light in which some points lie: two things whose cones are apart cannot
// shadow each other.

#include <halftone/geometry/bounds_tree.h>
#include <halftone/scene/world.h>

#include <span>

namespace halftone::shadow {

using core::Vec3;

class LightCone {
public:
  /// slack: by which points may be off, in scene units.
  LightCone(const Vec3& light, std::span<const Vec3> points, double slack);

  /// Never false where a segment from the light to a point of the convex hull of the other's points meets
  /// that of these.
  bool can_shadow(const LightCone& other) const;

  /// A box around the unit vectors of these directions: those of two things that can shadow each other meet.
  geometry::Bounds directions() const;

private:
  Vec3 axis_{0};
  double sine_ = 0, cosine_ = 0; ///< of the angle around the axis
  double from_ = 0, to_ = 0;     ///< distances from the light
  bool all_around_ = false;      ///< the light is among the points
};

} // namespace halftone::shadow
