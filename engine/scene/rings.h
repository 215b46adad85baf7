#pragma once
// Vertices and loops of prisms and faceted round shapes, in the object's coordinates (the scene format,
// section 1, last paragraph).

#include <halftone/scene/scene.h>

#include <utility>

namespace halftone::scene {

/// sin and cos of an angle in degrees, exact at multiples of 90 degrees.
std::pair<double, double> sin_cos_degrees(double degrees);

/// Loops are counter-clockwise seen from outside. The last `caps` faces are the flat ends.
struct Faceted {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  int caps = 0;
};

/// Prism or faceted frustum: n sides; an end of radius 0 is a single vertex without a cap.
Faceted faceted_frustum(const Frustum& frustum, int sides, double turn_degrees);

/// Poles on z, n meridians starting at x, n/2 bands (at least 2) of equal latitude.
Faceted faceted_sphere(const Sphere& sphere, int meridians);

Faceted box_faces(const Box& box);

} // namespace halftone::scene
