#include "place.h"

#include "rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::scene {

namespace {

struct Transform {
  core::Mat3 rotation{1};
  double scale = 1;
  Vec3 translate{0};

  Vec3 point(const Vec3& p) const { return translate + rotation * (scale * p); }
};

Transform make_transform(const Placement& placement) {
  const auto [sx, cx] = sin_cos_degrees(placement.rotate.x);
  const auto [sy, cy] = sin_cos_degrees(placement.rotate.y);
  const auto [sz, cz] = sin_cos_degrees(placement.rotate.z);
  // GLM's matrices are given column by column.
  const core::Mat3 x{1, 0, 0, 0, cx, sx, 0, -sx, cx};
  const core::Mat3 y{cy, 0, -sy, 0, 1, 0, sy, 0, cy};
  const core::Mat3 z{cz, sz, 0, -sz, cz, 0, 0, 0, 1};
  return {z * y * x, placement.scale, placement.translate};
}

/// a b - c d within two roundings of what it is (W. Kahan; C.-P. Jeannerod, N. Louvet, J.-M. Muller 2013).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// glm::cross of vectors along a needle loses its direction: the products cancel down to the needle's width.
Vec3 exact_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// Newell's plane (M. Newell; I. Sutherland, R. Sproull, R. Schumacker 1974), through the mean of the
/// corners. Taken about the first corner, so that a polygon far from the origin loses nothing: the sum of the
/// triangles that start there. Corners are off it by rounding of the polygon's size, however narrow it is.
Plane newell_plane(const std::vector<Vec3>& outline) {
  Vec3 normal{0}, mean{0};
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Vec3 a = outline[i] - outline[0];
    if (i + 1 < outline.size()) normal += exact_cross(a, outline[i + 1] - outline[0]);
    mean += a;
  }
  normal = glm::normalize(normal);
  mean = outline[0] + mean / static_cast<double>(outline.size());
  return {normal, glm::dot(normal, mean)};
}

void include(std::array<Vec3, 2>& bounds, const Vec3& low, const Vec3& high) {
  bounds[0] = glm::min(bounds[0], low);
  bounds[1] = glm::max(bounds[1], high);
}

std::array<Vec3, 2> no_bounds() {
  return {Vec3{std::numeric_limits<double>::infinity()}, Vec3{-std::numeric_limits<double>::infinity()}};
}

PlacedFace flat_face(std::vector<Vec3> outline) {
  PlacedFace face;
  face.surface = newell_plane(outline);
  face.outline = std::move(outline);
  return face;
}

PlacedBody placed_polyhedron(const Faceted& faceted, const Transform& to_world) {
  PlacedBody body;
  body.bounds = no_bounds();
  Vec3 mean{0};
  std::vector<Vec3> vertices;
  for (const Vec3& v : faceted.vertices) {
    vertices.push_back(to_world.point(v));
    include(body.bounds, vertices.back(), vertices.back());
    mean += vertices.back() / static_cast<double>(faceted.vertices.size());
  }
  for (const std::vector<int>& loop : faceted.faces) {
    std::vector<Vec3> outline;
    for (const int k : loop) outline.push_back(vertices[k]);
    PlacedFace face = flat_face(outline);
    // A file's polyhedron may run its loops either way; the mean of the vertices is inside.
    const Plane& plane = std::get<Plane>(face.surface);
    if (glm::dot(plane.normal, mean) > plane.offset) {
      std::reverse(outline.begin(), outline.end());
      face = flat_face(outline);
    }
    body.faces.push_back(std::move(face));
  }
  return body;
}

SphereSurface placed_surface(const Sphere& sphere, const Transform& to_world) {
  return {to_world.point(sphere.center), to_world.scale * sphere.radius};
}

ConeSurface placed_surface(const Frustum& frustum, const Transform& to_world) {
  const Vec3 base = to_world.point(frustum.base);
  const Vec3 axis = to_world.point(frustum.top) - base;
  const double length = glm::length(axis);
  const double base_radius = to_world.scale * frustum.base_radius;
  const double top_radius = to_world.scale * frustum.top_radius;
  return {base, axis / length, base_radius, (top_radius - base_radius) / length};
}

PlacedBody place_shape(const Sphere& sphere, const Transform& to_world) {
  const SphereSurface surface = placed_surface(sphere, to_world);
  PlacedBody body;
  body.kind = BodyKind::sphere;
  body.faces.push_back({surface});
  body.bounds = {surface.center - surface.radius, surface.center + surface.radius};
  return body;
}

PlacedBody place_shape(const Frustum& frustum, const Transform& to_world) {
  const ConeSurface side = placed_surface(frustum, to_world);
  const Vec3 top = to_world.point(frustum.top);
  PlacedBody body;
  body.kind = BodyKind::frustum;
  body.frustum =
      Frustum{side.origin, top, to_world.scale * frustum.base_radius, to_world.scale * frustum.top_radius};
  body.bounds = no_bounds();
  PlacedFace side_face{side};
  side_face.side_length = glm::length(top - side.origin);
  body.faces.push_back(side_face);
  const auto add_end = [&](const Vec3& center, double radius, const Vec3& outward) {
    // A disc reaches radius * sqrt(1 - axis_k^2) along axis k.
    const Vec3 reach = radius * glm::sqrt(glm::max(Vec3{0}, 1.0 - side.axis * side.axis));
    include(body.bounds, center - reach, center + reach);
    if (radius == 0) return;
    PlacedFace disc{Plane{outward, glm::dot(outward, center)}};
    disc.disc_center = center;
    disc.disc_radius = radius;
    body.faces.push_back(disc);
  };
  add_end(side.origin, to_world.scale * frustum.base_radius, -side.axis);
  add_end(top, to_world.scale * frustum.top_radius, side.axis);
  return body;
}

PlacedBody place_shape(const Box& box, const Transform& to_world) {
  return placed_polyhedron(box_faces(box), to_world);
}

PlacedBody place_shape(const Prism& prism, const Transform& to_world) {
  return placed_polyhedron(
      faceted_frustum({prism.base, prism.top, prism.radius, prism.radius}, prism.sides, prism.turn),
      to_world);
}

PlacedBody place_shape(const Polyhedron& polyhedron, const Transform& to_world) {
  return placed_polyhedron({polyhedron.vertices, polyhedron.faces}, to_world);
}

PlacedBody place_shape(const Polygon& polygon, const Transform& to_world) {
  PlacedBody body;
  body.kind = BodyKind::polygon;
  body.bounds = no_bounds();
  std::vector<Vec3> outline;
  for (const Vec3& v : polygon.vertices) {
    outline.push_back(to_world.point(v));
    include(body.bounds, outline.back(), outline.back());
  }
  body.faces.push_back(flat_face(std::move(outline)));
  return body;
}

/// The faceted stand-in of a round shape: its sides remember the round surface, for their shading normals.
PlacedBody stand_in(const Faceted& faceted, const Surface& round, const Transform& to_world) {
  PlacedBody body = placed_polyhedron(faceted, to_world);
  for (std::size_t k = 0; k + faceted.caps < body.faces.size(); ++k) body.faces[k].rounded = true;
  body.round = round;
  return body;
}

} // namespace

PlacedBody place(const Object& object, int facets) {
  const Transform to_world = make_transform(object.placement);
  if (object.trace == TraceRule::never) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape))
      return stand_in(faceted_sphere(*sphere, facets), placed_surface(*sphere, to_world), to_world);
    if (const auto* frustum = std::get_if<Frustum>(&object.shape))
      return stand_in(faceted_frustum(*frustum, facets, 0), placed_surface(*frustum, to_world), to_world);
  }
  return std::visit([&](const auto& shape) { return place_shape(shape, to_world); }, object.shape);
}

} // namespace halftone::scene
