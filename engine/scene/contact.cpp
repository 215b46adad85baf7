// Classes of coinciding faces. Our own: faces are taken from the largest to the smallest, and each joins the
// first class whose surface it fits, so that a class is represented by its largest face: extending a small
// face's plane over a large one would amplify the rounding of its normal. Opposite faces of one object never
// share a class, so that a solid thinner than the tolerance keeps its two sides.
//
// Invariant: a face's points lie within the tolerance of the surface that it is given.

#include "contact.h"

#include "plane_grid.h"
#include "round_grid.h"

#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <cmath>

namespace halftone::scene {

namespace {

double size_of(const PlacedFace& face) {
  if (const auto* sphere = std::get_if<SphereSurface>(&face.surface)) return sphere->radius;
  if (const auto* cone = std::get_if<ConeSurface>(&face.surface))
    return std::max({face.side_length, cone->radius, cone->radius + cone->slope * face.side_length});
  double size = face.disc_radius;
  for (const Vec3& p : face.outline) size = std::max(size, glm::length(p - face.outline[0]));
  return size;
}

/// Of a flat face.
Vec3 point_of(const PlacedFace& face) { return face.outline.empty() ? face.disc_center : face.outline[0]; }

bool fits(const SphereSurface& surface, const PlacedFace& face, double tolerance) {
  const auto& own = std::get<SphereSurface>(face.surface);
  return glm::length(own.center - surface.center) + std::abs(own.radius - surface.radius) <= tolerance;
}

/// Both end circles of the face lie on the surface, and it widens with it.
bool fits(const ConeSurface& surface, const PlacedFace& face, double tolerance) {
  const auto& own = std::get<ConeSurface>(face.surface);
  if (glm::length(glm::cross(surface.axis, own.axis)) > core::parallel) return false;
  const double slope = glm::dot(surface.axis, own.axis) > 0 ? own.slope : -own.slope;
  if (std::abs(surface.slope - slope) > core::parallel * (1 + slope * slope)) return false;
  for (const double height : {0.0, face.side_length}) {
    const Vec3 center = own.origin + own.axis * height - surface.origin;
    const double along = glm::dot(center, surface.axis);
    const double off_axis = glm::length(center - surface.axis * along);
    const double radius = own.radius + own.slope * height;
    if (off_axis + std::abs(radius - (surface.radius + surface.slope * along)) > tolerance) return false;
  }
  return true;
}

bool fits(const Plane& plane, const PlacedFace& face, double tolerance) {
  const Vec3& normal = std::get<Plane>(face.surface).normal;
  return farthest_from(plane, face) <= tolerance &&
         glm::length(glm::cross(plane.normal, normal)) <= core::parallel;
}

bool fits(const Surface& surface, const PlacedFace& face, double tolerance) {
  if (surface.index() != face.surface.index()) return false;
  return std::visit([&](const auto& s) { return fits(s, face, tolerance); }, surface);
}

/// Whether the body already has a face on this surface that looks the other way.
bool has_opposite(const PlacedBody& body, const std::vector<int>& surface_of, int surface,
                  const PlacedFace& face) {
  const auto* plane = std::get_if<Plane>(&face.surface);
  for (std::size_t f = 0; plane && f < surface_of.size(); ++f)
    if (surface_of[f] == surface &&
        glm::dot(std::get<Plane>(body.faces[f].surface).normal, plane->normal) < 0)
      return true;
  return false;
}

} // namespace

double farthest_from(const Plane& plane, const PlacedFace& face) {
  if (face.outline.empty()) {
    const Vec3& normal = std::get<Plane>(face.surface).normal;
    const Vec3 across = plane.normal - normal * glm::dot(plane.normal, normal);
    return std::abs(glm::dot(plane.normal, face.disc_center) - plane.offset) +
           face.disc_radius * glm::length(across);
  }
  double farthest = 0;
  for (const Vec3& p : face.outline)
    farthest = std::max(farthest, std::abs(glm::dot(plane.normal, p) - plane.offset));
  return farthest;
}

std::vector<Surface> share_surfaces(const std::vector<PlacedBody>& bodies, double tolerance,
                                    std::vector<std::vector<int>>& index_of) {
  struct Entry {
    int body, face;
    double size;
  };
  std::vector<Entry> entries;
  index_of.assign(bodies.size(), {});
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
    index_of[b].assign(bodies[b].faces.size(), -1);
    for (int f = 0; f < static_cast<int>(bodies[b].faces.size()); ++f)
      entries.push_back({b, f, size_of(bodies[b].faces[f])});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.size > b.size; });

  double flat_reach = 0, round_reach = 0; // from the origin
  for (const PlacedBody& body : bodies)
    for (const PlacedFace& face : body.faces) {
      if (const auto* sphere = std::get_if<SphereSurface>(&face.surface))
        round_reach = std::max({round_reach, glm::length(sphere->center), sphere->radius});
      else if (const auto* cone = std::get_if<ConeSurface>(&face.surface))
        round_reach = std::max(round_reach, glm::length(cone->origin));
      else if (face.outline.empty())
        flat_reach = std::max(flat_reach, glm::length(face.disc_center) + face.disc_radius);
      for (const Vec3& p : face.outline) flat_reach = std::max(flat_reach, glm::length(p));
    }

  std::vector<Surface> surfaces;
  PlaneGrid planes(flat_reach, core::parallel, tolerance);
  RoundGrid rounds(round_reach, tolerance);
  for (const Entry& entry : entries) {
    const PlacedFace& face = bodies[entry.body].faces[entry.face];
    const auto* plane = std::get_if<Plane>(&face.surface);
    std::vector<int>& own = index_of[entry.body];
    const std::vector<int> candidates =
        plane ? planes.near(*plane, point_of(face)) : rounds.near(face.surface);
    const auto chosen = std::find_if(candidates.begin(), candidates.end(), [&](int candidate) {
      return fits(surfaces[candidate], face, tolerance) &&
             !has_opposite(bodies[entry.body], own, candidate, face);
    });
    if (chosen != candidates.end()) {
      own[entry.face] = *chosen;
      continue;
    }
    own[entry.face] = static_cast<int>(surfaces.size());
    surfaces.push_back(face.surface);
    if (plane)
      planes.insert(*plane, own[entry.face]);
    else
      rounds.insert(face.surface, own[entry.face]);
  }
  return surfaces;
}

} // namespace halftone::scene
