#pragma once
// Where lines enter and leave solids and meet polygons, in exact arithmetic (exact.h), from the numbers that
// a scene gives: centers, ends and radii, corners; not from surfaces that were rounded when it was loaded.

#include "exact.h"

#include <halftone/geometry/line.h>
#include <halftone/scene/world.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace halftone::test {

template<typename Real>
struct ExactLine {
  ExactVec<Real> origin, direction; ///< of about unit length

  explicit ExactLine(const geometry::Line& line) : origin(line.origin), direction(line.direction) {}

  ExactVec<Real> at(const Real& t) const { return origin + t * direction; }
};

template<typename Real>
struct Ends {
  Real in = 0, out = 0;
};

/// A sphere or a frustum.
template<typename Real>
class ExactRound {
public:
  using Vec = ExactVec<Real>;

  explicit ExactRound(const scene::World& world) {
    const scene::Body& body = world.bodies[0];
    if (body.kind == scene::BodyKind::sphere) {
      const auto& sphere = std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]);
      base_ = Vec(sphere.center);
      base_radius_ = sphere.radius;
      return;
    }
    const scene::Frustum& f = *body.frustum;
    base_ = Vec(f.base);
    const Vec way = Vec(f.top) - base_;
    height_ = length(way);
    axis_ = (1 / height_) * way;
    base_radius_ = f.base_radius;
    slope_ = (Real(f.top_radius) - base_radius_) / height_;
    cosine_ = 1 / root(1 + slope_ * slope_);
  }

  /// Negative inside: the largest of the heights over its surfaces.
  Real height_over(const Vec& p) const {
    const Vec w = p - base_;
    if (height_ == 0) return length(w) - base_radius_;
    const Real along = dot(w, axis_);
    const Real side = (length(w - along * axis_) - (base_radius_ + slope_ * along)) * cosine_;
    return std::max({side, -along, along - height_});
  }

  /// Between which of the crossings with its surfaces the line is inside; from the point nearest to the base,
  /// so that it does not matter how far off the line starts.
  std::optional<Ends<Real>> span(const ExactLine<Real>& line) const {
    const Vec& direction = line.direction;
    const Real shift = dot(base_ - line.origin, direction) / dot(direction, direction);
    const Vec w = line.at(shift) - base_;
    const Real along = dot(w, axis_), forth = dot(direction, axis_);
    const Vec s = w - along * axis_, p = direction - forth * axis_;
    const Real radius = base_radius_ + slope_ * along, widening = slope_ * forth;
    const Vec turn = cross(s, p), apart = radius * p - widening * s;
    const Real a = dot(p, p) - widening * widening, b = dot(s, p) - radius * widening;
    const Real c = dot(s, s) - radius * radius, discriminant = dot(apart, apart) - dot(turn, turn);

    std::array<Real, 4> ends;
    int count = 0;
    if (a == 0) {
      if (!(b == 0)) ends[count++] = -c / (2 * b);
    } else if (!(discriminant < 0)) {
      const Real q = b > 0 ? -b - root(discriminant) : -b + root(discriminant);
      ends[count++] = q / a;
      if (!(q == 0)) ends[count++] = c / q;
    }
    if (!(height_ == 0) && !(forth == 0)) {
      ends[count++] = -along / forth;
      ends[count++] = (height_ - along) / forth;
    }
    std::sort(ends.begin(), ends.begin() + count);
    std::optional<Ends<Real>> span;
    for (int k = 0; k + 1 < count; ++k) {
      const Real from = shift + ends[k], to = shift + ends[k + 1];
      if (!(height_over(line.at((from + to) / 2)) < 0)) continue;
      if (!span) span = Ends<Real>{from, to};
      span->out = to;
    }
    return span;
  }

private:
  Vec base_; ///< the center of a sphere
  Vec axis_; ///< of unit length; none of a sphere
  Real height_ = 0, base_radius_ = 0, slope_ = 0;
  Real cosine_ = 1; ///< of the angle between side and axis
};

/// Newell's plane through the mean of the corners.
template<typename Real>
struct ExactPlane {
  ExactVec<Real> normal, mean;

  explicit ExactPlane(const std::vector<core::Vec3>& outline) {
    const ExactVec<Real> first(outline[0]);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const ExactVec<Real> a = ExactVec<Real>(outline[k]) - first;
      const ExactVec<Real> b = ExactVec<Real>(outline[(k + 1) % outline.size()]) - first;
      normal = normal + cross(a, b);
      mean = mean + a;
    }
    normal = (1 / length(normal)) * normal;
    mean = first + (1 / Real(static_cast<double>(outline.size()))) * mean;
  }

  Real height(const ExactVec<Real>& p) const { return dot(normal, p - mean); }
};

/// A polyhedron: what is behind the planes of its faces.
template<typename Real>
class ExactFlat {
public:
  explicit ExactFlat(const scene::World& world) {
    for (const scene::Face& face : world.bodies[0].faces) planes_.emplace_back(face.outline);
  }

  Real height_over(const ExactVec<Real>& p) const {
    Real highest = planes_[0].height(p);
    for (const auto& plane : planes_) highest = std::max(highest, plane.height(p));
    return highest;
  }

  std::optional<Ends<Real>> span(const ExactLine<Real>& line) const {
    std::optional<Real> in, out;
    for (const auto& plane : planes_) {
      const Real approach = dot(plane.normal, line.direction), height = plane.height(line.origin);
      if (approach == 0) {
        if (!(height < 0)) return std::nullopt;
        continue;
      }
      const Real t = -height / approach;
      if (approach < 0)
        in = in ? std::max(*in, t) : t;
      else
        out = out ? std::min(*out, t) : t;
    }
    if (!(*in < *out)) return std::nullopt;
    return Ends<Real>{*in, *out};
  }

private:
  std::vector<ExactPlane<Real>> planes_;
};

/// A polygon as lines see it: thrown along a line on the plane across it.
template<typename Real>
class ExactPolygon {
public:
  using Vec = ExactVec<Real>;

  explicit ExactPolygon(const scene::World& world) : plane_(world.bodies[0].faces[0].outline) {
    for (const core::Vec3& corner : world.bodies[0].faces[0].outline) corners_.emplace_back(corner);
  }

  Real height_over(const Vec& p) const { return plane_.height(p); }

  /// Whether the line meets it, ahead or not, and how far it passes from the nearest edge.
  std::pair<bool, Real> passes(const ExactLine<Real>& line) const {
    const Vec& d = line.direction;
    const Real per_length = 1 / dot(d, d);
    const auto thrown = [&](const Vec& corner) {
      const Vec from = corner - line.origin;
      return from - (dot(from, d) * per_length) * d;
    };
    int left = 0, right = 0;
    std::optional<Real> nearest;
    Vec a = thrown(corners_.back());
    for (const Vec& corner : corners_) {
      const Vec b = thrown(corner), edge = b - a;
      const Real turn = dot(cross(a, b), d), squared = dot(edge, edge);
      if (turn > 0) ++left;
      if (turn < 0) ++right;
      const Real share = squared > 0 ? std::clamp(-dot(a, edge) / squared, Real(0), Real(1)) : Real(0);
      const Real distance = length(a + share * edge);
      nearest = nearest ? std::min(*nearest, distance) : distance;
      a = b;
    }
    return {left == 0 || right == 0, *nearest};
  }

  /// Where the line meets its plane, if it is not parallel to it.
  std::optional<Real> crossing(const ExactLine<Real>& line) const {
    const Real approach = dot(plane_.normal, line.direction);
    if (approach == 0) return std::nullopt;
    return -plane_.height(line.origin) / approach;
  }

private:
  ExactPlane<Real> plane_;
  std::vector<Vec> corners_;
};

} // namespace halftone::test
