// The sphere by E. Haines et al., "Precision improvements for ray/sphere intersection" (Ray Tracing Gems,
// 2019, chapter 7): the perpendicular from the center first. The cone in its own frame, from the point of the
// line that is nearest to the cone's origin. There, with s the line's start and p its direction across the
// axis, R and w the cone's radius and its growth along the line,
//
//   |s + t p|^2 <= (R + t w)^2,   a = p.p - w w,   b = s.p - R w,   c = s.s - R R,
//
// and the discriminant b^2 - a c is |R p - w s|^2 - (s x p)^2 (Lagrange's identity), the form used here: its
// terms carry relative errors only, so that lines near the apex and at grazing angles are judged with an
// error in the first power of the rounding, where b^2 - a c has it under a root.
//
// Near a generator's direction, at a small angle e to the surface, rounding moves a root by u D / e along the
// line (u = 2^-53, D the distances that enter). On the nappe that is u D away from the surface; beyond the
// apex, where R + t w < 0, there is no surface of ours, and the line leaves it by the angle between two
// generators instead of e. No root of ours lies there, and so none is left there: it is held at the plane
// through the apex, R + t w = 0, whose crossing has the rounding of its two numbers only.
//
// Invariant: only the surface's numbers and the line enter, so every face on it gets the same bits.

#include "quadric.h"

#include <algorithm>
#include <cmath>

namespace halftone::geometry {

namespace {

/// After t, or else before it.
Range beyond(double t, bool after) {
  Range range;
  (after ? range.in : range.out) = t;
  return range;
}

/// Held at the apex where rounding carries a root beyond it.
double on_nappe(double root, double radius, double widening) {
  return radius + widening * root < 0 ? -radius / widening : root;
}

} // namespace

FramedCone framed(const scene::ConeSurface& cone) {
  const Vec3 hint = std::abs(cone.axis.x) > 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 u = glm::normalize(hint - cone.axis * glm::dot(hint, cone.axis));
  return {cone.origin, u, glm::cross(cone.axis, u), cone.axis, cone.radius, cone.slope};
}

Range range_in(const scene::SphereSurface& sphere, const Line& line) {
  const Vec3 to_center = sphere.center - line.origin;
  const double nearest = glm::dot(to_center, line.direction);
  const Vec3 apart = to_center - line.direction * nearest;
  const double half_squared = sphere.radius * sphere.radius - glm::dot(apart, apart);
  if (half_squared < 0) return nowhere;
  const double half = std::sqrt(half_squared);
  return {nearest - half, nearest + half};
}

Range range_in(const FramedCone& cone, const Line& line) {
  const Vec3 from_origin = line.origin - cone.origin;
  const double shift = -glm::dot(from_origin, line.direction);
  const Vec3 start = from_origin + line.direction * shift;
  const double sx = glm::dot(start, cone.u), sy = glm::dot(start, cone.v);
  const double px = glm::dot(line.direction, cone.u), py = glm::dot(line.direction, cone.v);
  const double radius = cone.radius + cone.slope * glm::dot(start, cone.axis);
  const double widening = cone.slope * glm::dot(line.direction, cone.axis);

  const double a = px * px + py * py - widening * widening;
  const double b = sx * px + sy * py - radius * widening;
  const double c = sx * sx + sy * sy - radius * radius;
  if (a == 0) {
    if (b == 0) { // along a cylinder, or along a generator of a cone
      if (c > 0) return nowhere;
      return widening == 0 ? Range{} : beyond(shift - radius / widening, widening > 0);
    }
    // Parallel to a generator: inside on one side of one crossing, which has to be the side of our nappe.
    return (b > 0) == (widening > 0) ? nowhere
                                     : beyond(shift + on_nappe(-c / (2 * b), radius, widening), b < 0);
  }
  const double qx = radius * px - widening * sx, qy = radius * py - widening * sy;
  const double turn = sx * py - sy * px;
  const double discriminant = qx * qx + qy * qy - turn * turn;
  if (discriminant < 0 && a > 0) return nowhere;
  // Both roots without cancellation (G. Forsythe 1966).
  const double q = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
  const double r1 = q / a;
  const double r2 = q == 0 ? r1 : c / q;
  const double low = std::min(r1, r2), high = std::max(r1, r2);
  if (a > 0) { // both on one nappe
    const bool on_ours = cone.slope == 0 || radius + widening * ((low + high) / 2) >= 0;
    if (!on_ours) return nowhere;
    return {shift + on_nappe(low, radius, widening), shift + on_nappe(high, radius, widening)};
  }
  return beyond(shift + on_nappe(widening > 0 ? high : low, radius, widening), widening > 0);
}

Range started(const Range& range, bool outward) {
  if (outward) return {std::min(range.in, 0.0), 0};
  return {0, std::max(range.out, 0.0)};
}

} // namespace halftone::geometry
