// Hidden bodies as the light sees them (W. Reeves, D. Salesin, R. Cook 1987 draw the same picture with
// depths). A point that such a body shadows is shadowed by the face before it as well: the way from the light
// to the point goes through the face first. The point is not on the face, nor on the face's body: there the
// way would end before it met the other.
//
// Invariant: the union of all shadows is the same as with all bodies.

#include <halftone/shadow/casters.h>

#include <algorithm>
#include <cmath>

namespace halftone::shadow {

namespace {

using core::Vec3;

/// Faces that are tried for each light: those that cover most of what it sees.
constexpr std::size_t most_occluders = 8;

/// An opaque face as the light sees it.
struct Occluder {
  int body = 0;
  double size = 0;         ///< about the solid angle
  scene::Plane plane;      ///< the light is on its positive side
  std::vector<Vec3> sides; ///< normals of the planes through the light and an edge, inward
};

Occluder occluder_of(int body, const geometry::Hull& hull, int face, const Vec3& light) {
  const std::vector<int>& loop = hull.faces[face];
  const scene::Plane& own = hull.planes[face];
  const double height = glm::dot(own.normal, light) - own.offset;
  const double sign = height < 0 ? -1 : 1;
  Occluder occluder{body, 0, {own.normal * sign, own.offset * sign}, {}};
  Vec3 middle{0}, twice_area{0};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = hull.vertices[loop[i]], &b = hull.vertices[loop[(i + 1) % loop.size()]];
    middle += a / static_cast<double>(loop.size());
    twice_area += glm::cross(a - hull.vertices[loop[0]], b - hull.vertices[loop[0]]);
    occluder.sides.push_back(glm::cross(a - light, b - light) * -sign);
  }
  const double distance = glm::length(middle - light);
  occluder.size = glm::length(twice_area) * std::abs(height) / (distance * distance * distance);
  return occluder;
}

bool hides(const Occluder& occluder, const geometry::Hull& hull, const Vec3& light) {
  return std::all_of(hull.vertices.begin(), hull.vertices.end(), [&](const Vec3& v) {
    if (glm::dot(occluder.plane.normal, v) - occluder.plane.offset >= 0) return false;
    return std::all_of(occluder.sides.begin(), occluder.sides.end(),
                       [&](const Vec3& side) { return glm::dot(side, v - light) > 0; });
  });
}

std::vector<Occluder> occluders(const scene::World& world, const std::vector<geometry::Hull>& hulls,
                                const Vec3& light) {
  // A light on a face, as far as touching goes, is not kept from anything by it.
  const double tolerance = scene::touching_distance(world);
  std::vector<Occluder> found;
  for (int body = 0; body < static_cast<int>(hulls.size()); ++body) {
    const scene::Body& own = world.bodies[body];
    const bool polygon = own.kind == scene::BodyKind::polygon;
    if (world.materials[own.material].glass || (!polygon && own.kind != scene::BodyKind::polyhedron))
      continue;
    for (int face = 0; face < static_cast<int>(hulls[body].faces.size()); ++face) {
      const scene::Plane& plane = hulls[body].planes[face];
      const double height = glm::dot(plane.normal, light) - plane.offset;
      if ((polygon ? std::abs(height) : height) > tolerance)
        found.push_back(occluder_of(body, hulls[body], face, light));
    }
  }
  const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(most_occluders, found.size()));
  std::partial_sort(found.begin(), end, found.end(), [](const Occluder& a, const Occluder& b) {
    return a.size != b.size ? a.size > b.size : a.body < b.body;
  });
  found.erase(end, found.end());
  return found;
}

} // namespace

std::vector<std::vector<int>> casters_by_light(const scene::World& world,
                                               const std::vector<geometry::Hull>& hulls) {
  std::vector<std::vector<int>> casters;
  for (const scene::Light& light : world.lights) {
    const std::vector<Occluder> large = occluders(world, hulls, light.position);
    std::vector<int>& list = casters.emplace_back();
    for (int body = 0; body < static_cast<int>(hulls.size()); ++body) {
      const bool is_hidden = std::any_of(large.begin(), large.end(), [&](const Occluder& occluder) {
        return occluder.body != body && hides(occluder, hulls[body], light.position);
      });
      if (!is_hidden) list.push_back(body);
    }
  }
  return casters;
}

} // namespace halftone::shadow
