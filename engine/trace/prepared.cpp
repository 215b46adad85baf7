#include "prepared.h"

#include <halftone/core/memory.h>
#include <halftone/geometry/position.h>

#include <numeric>

namespace halftone::trace {

namespace {

/// With fewer bodies a look at each is faster than a hierarchy, one by one or in packets
/// (docs/performance.md).
constexpr std::size_t least_in_tree = 32, least_in_tree_with_packets = 96;

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

/// Over the boxes of all bodies, for rays that start at the eye or on a body.
geometry::BoundsTree tree_of(const scene::World& world) {
  const double reach = std::max(glm::length(world.camera.eye), 2 * world.extent);
  std::vector<geometry::Bounds> boxes;
  for (const scene::Body& body : world.bodies) boxes.push_back(geometry::bounding_box(world, body, reach));
  return geometry::BoundsTree(boxes);
}

} // namespace

Prepared::Prepared(const scene::World& drawn, Search search, core::Simd simd)
    : world(drawn),
      solids(drawn),
      balls(drawn),
      exp(core::exp_of_three(simd)),
      media(drawn),
      around_eye(geometry::solids_around(drawn, drawn.camera.eye)),
      eye_surface(geometry::surface_under(drawn, drawn.camera.eye)) {
  for (const scene::Light& light : world.lights)
    lights.push_back({light, geometry::solids_around(world, light.position),
                      polygons_through(world, light.position),
                      geometry::planes_through(world, light.position), Casters(world, light.position)});
  const bool has_packets = geometry::Packets::has(simd);
  const std::size_t least = has_packets ? least_in_tree_with_packets : least_in_tree;
  if (search == Search::hierarchy || (search == Search::by_number && world.bodies.size() >= least))
    tree = tree_of(world);
  if (has_packets) packets.emplace(solids, balls, simd);
  all_bodies.resize(world.bodies.size());
  std::iota(all_bodies.begin(), all_bodies.end(), 0);
  eye_in_plane = std::any_of(solids.table.plane_surfaces.begin(), solids.table.plane_surfaces.end(),
                             [](const geometry::SolidTable::PlaneSurface& plane) { return plane.under_eye; });
}

std::size_t Prepared::memory() const {
  using core::memory_of;
  return solids.memory() + balls.memory() + media.memory() + (tree ? tree->memory() : 0) +
         (packets ? packets->memory() : 0) + memory_of(all_bodies) + memory_of(around_eye) +
         memory_of(lights, [](const PlacedLight& light) {
           return light.casters.memory() + memory_of(light.around) + memory_of(light.in_plane) +
                  memory_of(light.planes);
         });
}

} // namespace halftone::trace
