#pragma once
// From an object's own coordinates to a body in world space, its faces not yet matched with those of others.

#include <halftone/scene/world.h>

namespace halftone::scene {

/// A face on a surface of its own. A disc has a center and a radius; other flat faces have an outline.
struct PlacedFace {
  Surface surface;
  std::vector<Vec3> outline;
  Vec3 disc_center{0};
  double disc_radius = 0;
  double side_length = 0; ///< of a cone surface: it spans heights 0 to side_length
  bool rounded = false;
};

struct PlacedBody {
  BodyKind kind = BodyKind::polyhedron;
  std::vector<PlacedFace> faces; ///< in the order that Body::faces states
  std::optional<Frustum> frustum;
  std::optional<Surface> round;
  std::array<Vec3, 2> bounds{};
};

/// facets: sides of the stand-in, used where the object's rule is never.
PlacedBody place(const Object& object, int facets);

} // namespace halftone::scene
