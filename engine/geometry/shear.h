#pragma once
// A line seen along itself: points projected so that the line is the origin of a plane.

#include <halftone/geometry/line.h>

namespace halftone::geometry {

struct PlanePoint {
  double x = 0, y = 0;
};

class Shear {
public:
  explicit Shear(const Line& line);

  /// The same bits for the same point, whatever polygon it is a corner of.
  PlanePoint operator()(const Vec3& point) const;

private:
  Vec3 origin_{0};
  int x_ = 0, y_ = 1, z_ = 2; ///< z: the axis along which the line runs fastest
  double per_z_x_ = 0, per_z_y_ = 0;
};

/// Whether the edge between two points crosses the positive half of the x axis. Exact, and the same from
/// either end; a point on the axis counts as below it, an edge through the origin as left of it.
bool crosses_axis(const PlanePoint& a, const PlanePoint& b);

} // namespace halftone::geometry
