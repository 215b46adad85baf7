// Kay and Kajiya's slabs (1986) for convex polyhedra; quadrics from the point of the line that is nearest to
// the surface's middle (E. Haines et al., "Precision improvements for ray/sphere intersection", Ray Tracing
// Gems, 2019, chapter 7).
//
// Invariant: faces on one surface are met at the same t, to the bit, since t is calculated from the surface
// alone.

#include "cut.h"

#include <halftone/core/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::reference {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of a line inside a half-space or a quadric. Empty where in > out.
struct Range {
  double in = -infinity;
  double out = infinity;
};

constexpr Range nowhere{infinity, -infinity};

/// t at which the line meets the plane; infinite where it is parallel to it.
double distance_to(const scene::Plane& plane, const Line& line, bool is_under) {
  if (is_under) return 0;
  const double approach = glm::dot(plane.normal, line.direction);
  if (approach == 0) return infinity;
  return (plane.offset - glm::dot(plane.normal, line.origin)) / approach;
}

/// The half-space behind the face, whose outward normal is the plane's or opposite to it.
Range range_in(const scene::Plane& plane, const Line& line, bool starts_on, bool is_under, bool flipped) {
  const double approach = starts_on ? (line.outward ? 1.0 : -1.0) : glm::dot(plane.normal, line.direction);
  const double t = distance_to(plane, line, starts_on || is_under);
  if (approach == 0) {
    const double height = is_under ? 0 : glm::dot(plane.normal, line.origin) - plane.offset;
    return (flipped ? -height : height) < 0 ? Range{} : nowhere;
  }
  return (approach > 0) != flipped ? Range{-infinity, t} : Range{t, infinity};
}

/// A range that starts on the surface: one end is 0, and the side to which the line leaves says which.
Range started(const Range& range, bool outward) {
  if (outward) return {std::min(range.in, 0.0), 0};
  return {0, std::max(range.out, 0.0)};
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

/// |across|^2 - radius^2 = a t^2 + 2 b t + c, t measured from the point of the line nearest to the origin of
/// the cone. Inside is where that is not positive and the radius is not negative.
Range range_in(const scene::ConeSurface& cone, const Line& line) {
  const double shift = glm::dot(cone.origin - line.origin, line.direction);
  const Vec3 start = line.origin + line.direction * shift - cone.origin;
  const double start_height = glm::dot(start, cone.axis);
  const double climb = glm::dot(line.direction, cone.axis);
  const Vec3 start_across = start - cone.axis * start_height;
  const Vec3 step_across = line.direction - cone.axis * climb;
  const double start_radius = cone.radius + cone.slope * start_height;
  const double widening = cone.slope * climb;

  const double a = glm::dot(step_across, step_across) - widening * widening;
  const double b = glm::dot(start_across, step_across) - start_radius * widening;
  const double c = glm::dot(start_across, start_across) - start_radius * start_radius;
  if (a == 0) {
    if (b == 0) return c <= 0 ? Range{} : nowhere; // along a cylinder, or along a generator
    const double t = shift - c / (2 * b);
    return b > 0 ? Range{-infinity, t} : Range{t, infinity};
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0 && a > 0) return nowhere;
  // The stable form of both roots (G. Forsythe 1966): no cancellation in q.
  const double q = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
  const double r1 = q / a;
  const double r2 = q == 0 ? r1 : c / q;
  const double low = std::min(r1, r2), high = std::max(r1, r2);
  if (a > 0) { // both roots lie on one nappe
    const double radius = start_radius + widening * ((low + high) / 2);
    return cone.slope == 0 || radius >= 0 ? Range{shift + low, shift + high} : nowhere;
  }
  return widening > 0 ? Range{shift + high, infinity} : Range{-infinity, shift + low};
}

bool is_under_eye(const World& world, const scene::Surface& surface, const Line& line) {
  if (!line.at_eye) return false;
  const Height height = height_over(world, surface, line.origin);
  return std::abs(height.value) <= height.bound;
}

Range range_in(const World& world, const scene::Face& face, const Line& line) {
  const scene::Surface& surface = world.surfaces[face.surface];
  const bool starts_on = face.surface == line.surface;
  if (const auto* plane = std::get_if<scene::Plane>(&surface))
    return range_in(*plane, line, starts_on, is_under_eye(world, surface, line), face.flipped);
  const auto* sphere = std::get_if<scene::SphereSurface>(&surface);
  const Range range =
      sphere ? range_in(*sphere, line) : range_in(std::get<scene::ConeSurface>(surface), line);
  return starts_on ? started(range, line.outward) : range;
}

} // namespace

std::optional<Span> cut(const World& world, const Body& solid, const Line& line) {
  Span span{{-infinity, -1}, {infinity, -1}};
  for (int f = 0; f < static_cast<int>(solid.faces.size()); ++f) {
    const Range range = range_in(world, solid.faces[f], line);
    if (range.in > span.in.t) span.in = {range.in, f};
    if (range.out < span.out.t) span.out = {range.out, f};
    if (span.in.t >= span.out.t) return std::nullopt;
  }
  // Solids are bounded: a line without an end in one is not in it. Only faces that were given the surfaces of
  // others contradict each other so.
  if (span.in.face < 0 || span.out.face < 0) return std::nullopt;
  return span;
}

Crossing exit(const World& world, const Body& solid, const Line& line) {
  Crossing out{infinity, 0};
  for (int f = 0; f < static_cast<int>(solid.faces.size()); ++f) {
    const double t = range_in(world, solid.faces[f], line).out;
    if (t < out.t) out = {t, f};
  }
  if (!(out.t < infinity)) return {0, out.face}; // nothing keeps it in: it has left
  return {std::max(out.t, 0.0), out.face};
}

std::optional<Crossing> cross(const World& world, const Body& polygon, const Line& line) {
  const scene::Face& face = polygon.faces[0];
  if (face.surface == line.surface) return std::nullopt;
  if (is_under_eye(world, world.surfaces[face.surface], line)) return std::nullopt;
  const auto& plane = std::get<scene::Plane>(world.surfaces[face.surface]);
  const double t = distance_to(plane, line, false);
  if (!(t > 0 && t < infinity)) return std::nullopt;
  const Vec3 p = line.at(t);
  const Vec3 normal = face.flipped ? -plane.normal : plane.normal;
  for (std::size_t i = 0; i < face.outline.size(); ++i) {
    const Vec3& a = face.outline[i];
    const Vec3& b = face.outline[(i + 1) % face.outline.size()];
    if (glm::dot(glm::cross(b - a, p - a), normal) < 0) return std::nullopt;
  }
  return Crossing{t, 0};
}

Height height_over(const World& world, const scene::Surface& surface, const Vec3& point) {
  // Each value is below 10 roundings of terms no larger than those that gamma(10) multiplies; a plane was
  // made from coordinates up to the extent.
  const double size = glm::length(point);
  if (const auto* plane = std::get_if<scene::Plane>(&surface))
    return {glm::dot(plane->normal, point) - plane->offset,
            core::gamma(10) * (size + std::abs(plane->offset) + world.extent)};
  if (const auto* sphere = std::get_if<scene::SphereSurface>(&surface))
    return {glm::length(point - sphere->center) - sphere->radius,
            core::gamma(10) * (size + glm::length(sphere->center) + sphere->radius)};
  const auto& cone = std::get<scene::ConeSurface>(surface);
  const Vec3 from_origin = point - cone.origin;
  const double along = glm::dot(from_origin, cone.axis);
  return {glm::length(from_origin - cone.axis * along) - (cone.radius + cone.slope * along),
          core::gamma(10) * (1 + std::abs(cone.slope)) * (size + glm::length(cone.origin) + cone.radius)};
}

bool contains(const World& world, const Body& solid, const Vec3& point) {
  return std::all_of(solid.faces.begin(), solid.faces.end(), [&](const scene::Face& face) {
    const Height height = height_over(world, world.surfaces[face.surface], point);
    return (face.flipped ? -height.value : height.value) < -height.bound;
  });
}

} // namespace halftone::reference
