#include <halftone/geometry/position.h>

#include <halftone/core/rounding.h>

#include <algorithm>
#include <cmath>

namespace halftone::geometry {

// Each value is below 10 roundings of terms no larger than those that gamma(10) multiplies.
Height height_over(const scene::World& world, const scene::Surface& surface, const Vec3& point) {
  const double size = glm::length(point);
  if (const auto* plane = std::get_if<scene::Plane>(&surface))
    return {glm::dot(plane->normal, point) - plane->offset,
            core::gamma(10) * (size + std::abs(plane->offset) + world.extent)};
  if (const auto* sphere = std::get_if<scene::SphereSurface>(&surface))
    return {glm::length(point - sphere->center) - sphere->radius,
            core::gamma(10) * (size + glm::length(sphere->center) + sphere->radius)};
  const auto& cone = std::get<scene::ConeSurface>(surface);
  const Vec3 from_origin = point - cone.origin;
  const double along = glm::dot(from_origin, cone.axis);
  return {glm::length(from_origin - cone.axis * along) - (cone.radius + cone.slope * along),
          core::gamma(10) * (1 + std::abs(cone.slope)) * (size + glm::length(cone.origin) + cone.radius)};
}

std::vector<int> solids_around(const scene::World& world, const Vec3& point) {
  std::vector<int> around;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const scene::Body& body = world.bodies[b];
    if (body.kind == scene::BodyKind::polygon) continue;
    const bool inside = std::all_of(body.faces.begin(), body.faces.end(), [&](const scene::Face& face) {
      const Height height = height_over(world, world.surfaces[face.surface], point);
      return (face.flipped ? -height.value : height.value) < -height.bound;
    });
    if (inside) around.push_back(b);
  }
  return around;
}

std::vector<int> planes_through(const scene::World& world, const Vec3& point) {
  std::vector<int> planes;
  for (int s = 0; s < static_cast<int>(world.surfaces.size()); ++s)
    if (std::holds_alternative<scene::Plane>(world.surfaces[s]) &&
        height_over(world, world.surfaces[s], point).is_on())
      planes.push_back(s);
  return planes;
}

int surface_under(const scene::World& world, const Vec3& point) {
  int under = -1;
  for (int s = 0; s < static_cast<int>(world.surfaces.size()); ++s) {
    if (!height_over(world, world.surfaces[s], point).is_on()) continue;
    if (!std::holds_alternative<scene::Plane>(world.surfaces[s])) return s;
    if (under < 0) under = s;
  }
  return under;
}

} // namespace halftone::geometry
