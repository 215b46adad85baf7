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
// Where w is below |p| / 2, a is above 3/4 p.p, and t = (-b +- root) / a is off by the rounding of s over
// |p|, which is the rounding of s across the axis. (c / q, G. Forsythe's form of the smaller root, 1966, is
// not: where a line touches the surface at the point nearest to the origin, c and q are both rounding.)
//
// Otherwise the line may have nearly the direction of a generator, where a is rounding, and meet the surface
// near the apex, where what is rounding to s is not to the radius. There the unknown is r = R + t w, the
// radius at the crossing, instead of t: with g = R p - w s, which is -w times the place where the line passes
// the plane through the apex,
//
//   a r^2 - 2 (g.p) r + g.g = 0,   whose discriminant is w w g.g - (g x p)^2,
//
// so that s and R enter by g alone, and its rounding is a move of the line by that of s. All else carries
// relative errors, roots by Forsythe's forms too, and our nappe is r >= 0. (Our own.)
//
// Invariant: only the surface's numbers and the line enter, so every face on it gets the same bits.

#include "quadric.h"

#include <algorithm>
#include <cmath>

namespace halftone::geometry {

namespace {

/// A line in a cone's frame: across the axis it is at s and moves by p, where the cone's radius is `radius`
/// and grows by `widening`.
struct Framed {
  double sx, sy, px, py, radius, widening;
};

/// By the distance from the start. The double cone is met twice on one nappe, or not at all.
Range by_distance(const Framed& f, double a, double gx, double gy) {
  if (a == 0) // along a cylinder
    return f.sx * f.sx + f.sy * f.sy > f.radius * f.radius ? nowhere : Range{};
  const double b = f.sx * f.px + f.sy * f.py - f.radius * f.widening;
  const double turn = f.sx * f.py - f.sy * f.px;
  const double discriminant = gx * gx + gy * gy - turn * turn;
  if (discriminant < 0 || f.radius - f.widening * (b / a) < 0) return nowhere; // in the middle of both
  const double root = std::sqrt(discriminant);
  return {-(b + root) / a, (root - b) / a};
}

/// By the radius at the crossing.
Range by_radius(const Framed& f, double a, double gx, double gy) {
  const double b = gx * f.px + gy * f.py, c = gx * gx + gy * gy;
  const double turn = gx * f.py - gy * f.px;
  const double discriminant = f.widening * f.widening * c - turn * turn;
  const auto distance = [&](double radius) { return (radius - f.radius) / f.widening; };
  if (a >= 0) { // both on one nappe, the farther at infinity where a == 0
    if (discriminant < 0 || !(b > 0)) return nowhere;
    const double q = b + std::sqrt(discriminant);
    const double near_apex = distance(c / q), away = distance(q / a);
    return f.widening > 0 ? Range{near_apex, away} : Range{away, near_apex};
  }
  const double q = b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b); // one root on each
  Range range;
  (f.widening > 0 ? range.in : range.out) = distance(q > 0 ? c / q : q / a);
  return range;
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
  const Framed f{glm::dot(start, cone.u),
                 glm::dot(start, cone.v),
                 glm::dot(line.direction, cone.u),
                 glm::dot(line.direction, cone.v),
                 cone.radius + cone.slope * glm::dot(start, cone.axis),
                 cone.slope * glm::dot(line.direction, cone.axis)};
  const double across = f.px * f.px + f.py * f.py, grown = f.widening * f.widening;
  const double gx = f.radius * f.px - f.widening * f.sx, gy = f.radius * f.py - f.widening * f.sy;
  const Range range =
      4 * grown > across ? by_radius(f, across - grown, gx, gy) : by_distance(f, across - grown, gx, gy);
  return {shift + range.in, shift + range.out};
}

Range started(const Range& range, bool outward) {
  if (outward) return {std::min(range.in, 0.0), 0};
  return {0, std::max(range.out, 0.0)};
}

} // namespace halftone::geometry
