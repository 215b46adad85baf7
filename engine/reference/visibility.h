#pragma once
// V of the scene format's section 4: how much of a light reaches a point, along the straight segment.

#include "meeting.h"

namespace halftone::reference {

/// A light, the solids that contain it, the polygons in whose planes it lies, which cannot shadow anything,
/// and the planes in which it lies, behind which solids shadow nothing that is before them.
struct PlacedLight {
  scene::Light light;
  Inside around;
  std::vector<int> polygons;
  std::vector<int> planes; ///< indices into World::surfaces, ascending
};

/// The polygons whose planes contain the point, up to rounding, in ascending order.
std::vector<int> polygons_through(const World& world, const Vec3& point);

/// The same for planes of solids.
std::vector<int> planes_through(const World& world, const Vec3& point);

/// Per channel, in [0, 1]. point lies on the surface `surface`, on the face of the body `own`.
scene::Color visibility(const World& world, const PlacedLight& light, const Vec3& point, int surface,
                        int own);

} // namespace halftone::reference
