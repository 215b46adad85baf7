// Planes: M. Cyrus and J. Beck, "Generalized two- and three-dimensional clipping" (1978). Quadrics: the part
// of the line where the implicit function is not positive, cut with the slab of the ends; within that slab a
// frustum has one nappe.

#include "convex.h"

#include <cmath>
#include <limits>

namespace halftone::bench {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Cuts the span with [from, to]; false where nothing is left.
bool clip(Span& span, double from, double to, int face) {
  if (from > span.in) {
    span.in = from;
    span.in_face = face;
  }
  if (to < span.out) {
    span.out = to;
    span.out_face = face;
  }
  return span.in < span.out;
}

} // namespace

Convex::Convex(const scene::World& world, int index) : body_(index) {
  const scene::Body& body = world.bodies[index];
  kind_ = body.kind;
  for (int f = 0; f < static_cast<int>(body.faces.size()); ++f) {
    const scene::Surface& surface = world.surfaces[body.faces[f].surface];
    if (const auto* plane = std::get_if<scene::Plane>(&surface)) {
      const double side = body.faces[f].flipped ? -1 : 1;
      planes_.push_back({side * plane->normal, side * plane->offset, f});
    } else if (const auto* sphere = std::get_if<scene::SphereSurface>(&surface)) {
      sphere_ = *sphere;
    } else {
      cone_ = std::get<scene::ConeSurface>(surface);
    }
  }
  if (kind_ != scene::BodyKind::frustum) return;
  // An end that is a point has no face, but the solid ends there.
  const scene::Frustum& f = *body.frustum;
  const Vec3 axis = glm::normalize(f.top - f.base);
  if (f.base_radius == 0) planes_.push_back({-axis, -glm::dot(axis, f.base), 0});
  if (f.top_radius == 0) planes_.push_back({axis, glm::dot(axis, f.top), 0});
}

bool Convex::clip_by_planes(const Line& line, Span& span) const {
  for (const HalfSpace& plane : planes_) {
    const double rate = glm::dot(plane.normal, line.direction);
    const double depth = plane.offset - glm::dot(plane.normal, line.origin);
    if (rate == 0) {
      if (depth < 0) return false;
    } else if (rate < 0) {
      if (!clip(span, depth / rate, infinite, plane.face)) return false;
    } else if (!clip(span, -infinite, depth / rate, plane.face)) {
      return false;
    }
  }
  return true;
}

bool Convex::clip_by_sphere(const Line& line, Span& span) const {
  const Vec3 from_center = line.origin - sphere_.center;
  const double nearest = -glm::dot(from_center, line.direction);
  const Vec3 off = from_center + nearest * line.direction;
  const double squared = sphere_.radius * sphere_.radius - glm::dot(off, off);
  if (squared <= 0) return false;
  const double half = std::sqrt(squared);
  return clip(span, nearest - half, nearest + half, 0);
}

bool Convex::clip_by_cone(const Line& line, Span& span) const {
  const Vec3 from_origin = line.origin - cone_.origin;
  const double h = glm::dot(cone_.axis, from_origin), rise = glm::dot(cone_.axis, line.direction);
  const Vec3 p = from_origin - h * cone_.axis, d = line.direction - rise * cone_.axis;
  const double radius = cone_.radius + cone_.slope * h, growth = cone_.slope * rise;
  const double a = glm::dot(d, d) - growth * growth;
  const double b = glm::dot(p, d) - radius * growth;
  const double c = glm::dot(p, p) - radius * radius;
  if (a == 0) {
    if (b == 0) return c <= 0;
    const double t = -c / (2 * b);
    return b > 0 ? clip(span, -infinite, t, 0) : clip(span, t, infinite, 0);
  }
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return a < 0;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  double first = q / a, second = c / q;
  if (first > second) std::swap(first, second);
  if (a > 0) return clip(span, first, second, 0);
  // Steeper than the side: inside both nappes, of which the growing one is ours.
  return growth > 0 ? clip(span, second, infinite, 0) : clip(span, -infinite, first, 0);
}

std::optional<Span> Convex::cut(const Line& line) const {
  Span span{-infinite, infinite, -1, -1};
  if (kind_ == scene::BodyKind::sphere) {
    if (!clip_by_sphere(line, span)) return std::nullopt;
  } else if (!clip_by_planes(line, span) ||
             (kind_ == scene::BodyKind::frustum && !clip_by_cone(line, span))) {
    return std::nullopt;
  }
  return span;
}

bool Convex::contains(const Vec3& point) const {
  for (const HalfSpace& plane : planes_)
    if (glm::dot(plane.normal, point) >= plane.offset) return false;
  if (kind_ == scene::BodyKind::sphere) return glm::distance(point, sphere_.center) < sphere_.radius;
  if (kind_ != scene::BodyKind::frustum) return true;
  const double h = glm::dot(cone_.axis, point - cone_.origin);
  return glm::length(point - cone_.origin - h * cone_.axis) < cone_.radius + cone_.slope * h;
}

} // namespace halftone::bench
