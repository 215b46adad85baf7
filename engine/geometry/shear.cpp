// S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection" (2013): corners are sheared so that
// the line is the z axis, and rounded once; what follows is a question about points of the plane. Changed: it
// is answered by the number of edges that the positive x axis crosses, half-open and with exact signs, so
// that of the polygons around a corner, too, exactly one contains the origin.
//
// Invariant: if polygons share their corners to the bit and together tile a part of the plane, every line
// that is projected into that part is in exactly one of them.

#include "shear.h"

#include <cmath>

namespace halftone::geometry {

namespace {

/// The sign of a.x b.y - a.y b.x. Rounding is monotonous: products that differ after it differ that way
/// before it; the error of a product is a double, which fma gives.
int turn(const PlanePoint& a, const PlanePoint& b) {
  const double p = a.x * b.y, q = a.y * b.x;
  if (p != q) return p > q ? 1 : -1;
  const double p_error = std::fma(a.x, b.y, -p), q_error = std::fma(a.y, b.x, -q);
  return p_error > q_error ? 1 : p_error < q_error ? -1 : 0;
}

} // namespace

Shear::Shear(const Line& line) : origin_(line.origin) {
  const Vec3 size = glm::abs(line.direction);
  z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  per_z_x_ = line.direction[x_] / line.direction[z_];
  per_z_y_ = line.direction[y_] / line.direction[z_];
}

PlanePoint Shear::operator()(const Vec3& point) const {
  const Vec3 from = point - origin_;
  return {from[x_] - per_z_x_ * from[z_], from[y_] - per_z_y_ * from[z_]};
}

bool crosses_axis(const PlanePoint& a, const PlanePoint& b) {
  if ((a.y <= 0) == (b.y <= 0)) return false;
  return (a.y <= 0 ? turn(a, b) : turn(b, a)) > 0;
}

} // namespace halftone::geometry
