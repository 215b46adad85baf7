// Tadamura, Nakamae, Nishita (c. 1986), section 3.1: bounding convex polyhedra about the object's own axis.
// There the ends are squares around the two circles; ours are octagons, and a sphere has bands instead of a
// cube, which leaves less empty area to be traced (docs/method.md has the measurement).
//
// Circles start where the camera says, not the world's axes: a scene that is turned, mirrored or moved with
// its camera is cut at the same places and is the same picture (tests/stability/invariance_test.cpp).
//
// Invariant: the hull contains the body, to the rounding of its coordinates (tested to 10⁻¹³ of them).
// Rings are moved outward by more than their rounding; ends of an axis stay where they are, so
// that a hull touches what its body stands on.

#include <halftone/geometry/bounding.h>

#include <halftone/core/elementary.h>
#include <halftone/core/memory.h>
#include <halftone/core/rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

namespace halftone::geometry {

namespace {

/// Two unit vectors that make a right-handed frame with a unit axis; the first turns with the camera.
std::pair<Vec3, Vec3> across(const Vec3& axis, const scene::CameraFrame& camera) {
  const bool along_view = std::abs(glm::dot(axis, camera.forward)) > 0.9;
  const Vec3 hint = along_view ? camera.right / glm::length(camera.right) : camera.forward;
  const Vec3 u = glm::normalize(hint - axis * glm::dot(hint, axis));
  return {u, glm::cross(axis, u)};
}

scene::Plane plane_through(const std::vector<Vec3>& vertices, const std::vector<int>& loop) {
  const Vec3& a = vertices[loop[0]];
  const Vec3 normal = glm::normalize(glm::cross(vertices[loop[1]] - a, vertices[loop[loop.size() - 1]] - a));
  return {normal, glm::dot(normal, a)};
}

void add_planes(Hull& hull) {
  for (const auto& loop : hull.faces) hull.planes.push_back(plane_through(hull.vertices, loop));
}

Hull hull_of_flat(const scene::World& world, const scene::Body& body) {
  Hull hull;
  for (const scene::Face& face : body.faces) {
    std::vector<int> loop;
    for (const Vec3& corner : face.outline) {
      const auto known = std::find(hull.vertices.begin(), hull.vertices.end(), corner);
      loop.push_back(static_cast<int>(known - hull.vertices.begin()));
      if (known == hull.vertices.end()) hull.vertices.push_back(corner);
    }
    hull.faces.push_back(std::move(loop));
    scene::Plane plane = std::get<scene::Plane>(world.surfaces[face.surface]);
    if (face.flipped) plane = {-plane.normal, -plane.offset};
    hull.planes.push_back(plane);
  }
  return hull;
}

/// Bands between rings around the axis, closed by a vertex or a flat face at each end.
struct Ring {
  Vec3 center;
  double radius; ///< 0: a single vertex
};

int corners_of(const Ring& ring, int sides) { return ring.radius > 0 ? sides : 1; }

std::vector<Vec3> corners_of_rings(std::span<const Ring> rings, const Vec3& axis,
                                   const scene::CameraFrame& camera, int sides) {
  const auto [u, v] = across(axis, camera);
  std::vector<Vec3> corners;
  for (const Ring& ring : rings)
    for (int k = 0; k < corners_of(ring, sides); ++k) {
      const auto [sin, cos] = core::sin_cos(2 * std::numbers::pi * k / sides);
      corners.push_back(ring.center + ring.radius * (u * cos + v * sin));
    }
  return corners;
}

std::vector<std::vector<int>> faces_of_rings(std::span<const Ring> rings, int sides) {
  std::vector<std::vector<int>> loops;
  int first = 0;
  for (const Ring& ring : rings) {
    std::vector<int>& loop = loops.emplace_back(corners_of(ring, sides));
    std::iota(loop.begin(), loop.end(), first);
    first += corners_of(ring, sides);
  }
  std::vector<std::vector<int>> faces;
  for (std::size_t r = 0; r + 1 < loops.size(); ++r) {
    for (int k = 0; k < sides; ++k) {
      const auto at = [&](const std::vector<int>& loop, int i) { return loop[i % loop.size()]; };
      std::vector<int> side{at(loops[r], k), at(loops[r], k + 1), at(loops[r + 1], k + 1),
                            at(loops[r + 1], k)};
      side.erase(std::unique(side.begin(), side.end()), side.end());
      if (side.front() == side.back()) side.pop_back();
      faces.push_back(std::move(side));
    }
  }
  if (loops.front().size() > 1) faces.emplace_back(loops.front().rbegin(), loops.front().rend());
  if (loops.back().size() > 1) faces.push_back(loops.back());
  return faces;
}

Hull hull_of_rings(std::span<const Ring> rings, const Vec3& axis, const scene::CameraFrame& camera,
                   int sides) {
  Hull hull{corners_of_rings(rings, axis, camera, sides), faces_of_rings(rings, sides), {}};
  add_planes(hull);
  return hull;
}

std::array<Ring, 2> rings_of(const scene::Frustum& frustum) {
  return {{{frustum.base, frustum.base_radius}, {frustum.top, frustum.top_radius}}};
}

/// A regular polygon around a circle has its corners farther out by this, and by the rounding of a
/// coordinate.
double ring_radius(double radius, int sides, double size) {
  return radius / core::sin_cos(std::numbers::pi / sides).cos + core::gamma(32) * size;
}

Hull hull_of_sphere(const scene::SphereSurface& sphere, const scene::CameraFrame& camera, int sides) {
  const int bands = sides / 2;
  std::vector<Ring> rings;
  const Vec3 axis = camera.up / glm::length(camera.up);
  for (int band = 0; band <= bands; ++band) {
    const auto [sin, cos] = core::sin_cos(std::numbers::pi * band / bands);
    const bool pole = band == 0 || band == bands;
    rings.push_back({-axis * cos, pole ? 0 : sin});
  }
  Hull hull = hull_of_rings(rings, axis, camera, sides);
  // Inscribed in the unit sphere so far: grow it until its nearest face touches the sphere.
  double nearest = 1;
  for (const scene::Plane& plane : hull.planes) nearest = std::min(nearest, plane.offset);
  const double size = glm::length(sphere.center) + sphere.radius;
  const double growth = sphere.radius / nearest + core::gamma(64) * size;
  for (Vec3& v : hull.vertices) v = sphere.center + v * growth;
  hull.planes.clear();
  add_planes(hull);
  return hull;
}

} // namespace

std::size_t memory_of(const Hull& hull) {
  using core::memory_of;
  return memory_of(hull.vertices) + memory_of(hull.planes) +
         memory_of(hull.faces, [](const std::vector<int>& loop) { return memory_of(loop); });
}

Hull bounding_hull(const scene::World& world, const scene::Body& body, int sides) {
  const scene::Surface& surface = world.surfaces[body.faces[0].surface];
  if (body.kind == scene::BodyKind::sphere)
    return hull_of_sphere(std::get<scene::SphereSurface>(surface), world.camera, sides);
  if (body.kind != scene::BodyKind::frustum) return hull_of_flat(world, body);
  const scene::Frustum& shape = *body.frustum;
  const Vec3 axis = glm::normalize(shape.top - shape.base);
  const double size = glm::length(shape.base) + glm::length(shape.top) + shape.base_radius + shape.top_radius;
  const auto ring = [&](const Vec3& center, double radius) {
    return Ring{center, radius > 0 ? ring_radius(radius, sides, size) : 0};
  };
  const std::array rings{ring(shape.base, shape.base_radius), ring(shape.top, shape.top_radius)};
  return hull_of_rings(rings, axis, world.camera, sides);
}

std::vector<Vec3> inscribed_corners(const scene::Frustum& frustum, const scene::CameraFrame& camera,
                                    int sides) {
  return corners_of_rings(rings_of(frustum), glm::normalize(frustum.top - frustum.base), camera, sides);
}

std::vector<std::vector<int>> inscribed_faces(const scene::Frustum& frustum, int sides) {
  return faces_of_rings(rings_of(frustum), sides);
}

Hull inscribed_hull(const scene::Frustum& frustum, const scene::CameraFrame& camera, int sides) {
  return hull_of_rings(rings_of(frustum), glm::normalize(frustum.top - frustum.base), camera, sides);
}

std::vector<Vec3> tangent_circle(const scene::SphereSurface& sphere, const Vec3& from,
                                 const scene::CameraFrame& camera, int sides) {
  const Vec3 to_center = sphere.center - from;
  const double distance = glm::length(to_center);
  // With sine = r / d of the cone's half angle, the circle lies r sine nearer than the center.
  const double sine = sphere.radius / distance;
  const Vec3 axis = to_center / distance;
  const Vec3 center = sphere.center - axis * (sphere.radius * sine);
  const double radius = sphere.radius * std::sqrt((1 - sine) * (1 + sine));
  const auto [u, v] = across(axis, camera);
  std::vector<Vec3> circle;
  for (int k = 0; k < sides; ++k) {
    const auto [sin, cos] = core::sin_cos(2 * std::numbers::pi * k / sides);
    circle.push_back(center + radius * (u * cos + v * sin));
  }
  return circle;
}

} // namespace halftone::geometry
