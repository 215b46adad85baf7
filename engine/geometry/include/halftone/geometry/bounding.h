#pragma once
// The convex polyhedron that stands for a body until it is shaded: the body itself where it is flat,
// otherwise one circumscribed about the round shape. The corners on circles turn with the camera.

#include <halftone/scene/world.h>

#include <vector>

namespace halftone::geometry {

using core::Vec3;

/// World space. Loops are counter-clockwise seen from outside; of a polygon there is one, seen from both
/// sides.
struct Hull {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<scene::Plane> planes; ///< of each face, the normal outward
};

/// Bytes that the hull holds.
std::size_t memory_of(const Hull& hull);

/// Contains every point of the body, to the rounding of its coordinates. Faces of a flat body keep the order
/// of Body::faces and the planes of World::surfaces. sides: of the polyhedron about a round shape; even, at
/// least 4.
Hull bounding_hull(const scene::World& world, const scene::Body& body, int sides = 8);

/// A frustum with both circles replaced by inscribed polygons of as many sides (at least 3). The faces of the
/// side come first, then the caps.
Hull inscribed_hull(const scene::Frustum& frustum, const scene::CameraFrame& camera, int sides);

/// Its vertices and its faces alone.
std::vector<Vec3> inscribed_corners(const scene::Frustum& frustum, const scene::CameraFrame& camera,
                                    int sides);
std::vector<std::vector<int>> inscribed_faces(const scene::Frustum& frustum, int sides);

/// Where the cone of tangents from a point outside of a sphere touches it: a circle, replaced by an inscribed
/// polygon.
std::vector<Vec3> tangent_circle(const scene::SphereSurface& sphere, const Vec3& from,
                                 const scene::CameraFrame& camera, int sides);

} // namespace halftone::geometry
