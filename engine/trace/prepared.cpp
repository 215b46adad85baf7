#include "prepared.h"

#include <halftone/geometry/position.h>

namespace halftone::trace {

namespace {

std::vector<int> polygons_through(const scene::World& world, const core::Vec3& point) {
  std::vector<int> polygons;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const scene::Body& body = world.bodies[b];
    if (body.kind == scene::BodyKind::polygon &&
        geometry::height_over(world, world.surfaces[body.faces[0].surface], point).is_on())
      polygons.push_back(b);
  }
  return polygons;
}

} // namespace

Prepared::Prepared(const scene::World& drawn)
    : world(drawn),
      solids(drawn),
      balls(drawn),
      media(drawn),
      around_eye(geometry::solids_around(drawn, drawn.camera.eye)),
      eye_surface(geometry::surface_under(drawn, drawn.camera.eye)) {
  for (const scene::Light& light : world.lights)
    lights.push_back({light, geometry::solids_around(world, light.position),
                      polygons_through(world, light.position),
                      geometry::planes_through(world, light.position), Casters(world, light.position)});
}

} // namespace halftone::trace
