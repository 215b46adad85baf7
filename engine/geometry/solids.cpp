// Kay and Kajiya's slabs (1986) for convex polyhedra; quadrics in quadric.cpp; polygons in the plane across
// the line, in shear.cpp.
//
// Invariant: t is calculated from the shared surface and the line alone. A face whose outward normal is
// opposite to the plane's has the normal and the offset negated, which negates numerator and denominator
// exactly and leaves t.

#include <halftone/geometry/solids.h>

#include "quadric.h"
#include "shear.h"

#include <halftone/core/memory.h>
#include <halftone/core/rounding.h>
#include <halftone/geometry/position.h>

#include <algorithm>

namespace halftone::geometry {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SolidTable table_of(const scene::World& world) {
  SolidTable table;
  auto& [all, planes, plane_surfaces, spheres, cones, corners] = table;
  for (const scene::Body& body : world.bodies) {
    SolidTable::Parts parts{body.kind};
    parts.first = static_cast<int>(planes.size());
    parts.corner = static_cast<int>(corners.size());
    for (const scene::Face& face : body.faces) {
      const scene::Surface& surface = world.surfaces[face.surface];
      if (const auto* plane = std::get_if<scene::Plane>(&surface)) {
        if (face.flipped)
          planes.push_back({-plane->normal, -plane->offset});
        else
          planes.push_back({plane->normal, plane->offset});
        plane_surfaces.push_back(
            {face.surface, face.flipped, height_over(world, surface, world.camera.eye).is_on()});
        continue;
      }
      parts.round_surface = face.surface;
      if (const auto* sphere = std::get_if<scene::SphereSurface>(&surface)) {
        parts.round = static_cast<int>(spheres.size());
        spheres.push_back(*sphere);
      } else {
        parts.round = static_cast<int>(cones.size());
        cones.push_back(framed(std::get<scene::ConeSurface>(surface)));
      }
    }
    parts.count = static_cast<int>(planes.size()) - parts.first;
    if (body.kind == scene::BodyKind::polygon)
      corners.insert(corners.end(), body.faces[0].outline.begin(), body.faces[0].outline.end());
    parts.corners = static_cast<int>(corners.size()) - parts.corner;
    for (int k = parts.corner; k < parts.corner + parts.corners; ++k)
      parts.reach = std::max(parts.reach, glm::length(corners[k]));
    all.push_back(parts);
  }
  return table;
}

} // namespace

Solids::Solids(const scene::World& world) : table(table_of(world)) {}

std::size_t Solids::memory() const {
  using core::memory_of;
  return memory_of(table.parts) + memory_of(table.planes) + memory_of(table.plane_surfaces) +
         memory_of(table.spheres) + memory_of(table.cones) + memory_of(table.corners);
}

/// How a line passes a plane: positive approach is on its way out.
struct Solids::Pass {
  double approach = 0;
  double depth = 0; ///< of the line's origin behind the plane

  Pass(const SolidTable::OutwardPlane& plane, const SolidTable::PlaneSurface& on, const Line& line) {
    if (on.surface == line.surface) {
      approach = line.outward != on.flipped ? 1 : -1;
    } else {
      approach = glm::dot(plane.normal, line.direction);
      depth = line.at_eye && on.under_eye ? 0 : plane.offset - glm::dot(plane.normal, line.origin);
    }
  }
};

/// Narrows the span to what lies behind all planes of a solid. False where nothing of it lies ahead.
bool Solids::clip(const Parts& parts, const Line& line, Span& span) const {
  const int first_face = parts.kind == scene::BodyKind::frustum ? 1 : 0;
  Crossing in = span.in, out = span.out;
  for (int k = 0; k < parts.count; ++k) {
    const Pass pass(table.planes[parts.first + k], table.plane_surfaces[parts.first + k], line);
    if (pass.approach < 0) {
      const double t = pass.depth / pass.approach;
      if (t > in.t) in = {t, first_face + k};
    } else if (!(pass.depth > 0)) { // in front of the plane, and not on the way in
      return false;
    } else if (pass.approach > 0) {
      const double t = pass.depth / pass.approach;
      if (t < out.t) out = {t, first_face + k};
    }
    if (in.t >= out.t) return false;
  }
  span = {in, out};
  return true;
}

/// Moves the exit to the first plane that the line leaves by.
void Solids::limit(const Parts& parts, const Line& line, Crossing& out) const {
  const int first_face = parts.kind == scene::BodyKind::frustum ? 1 : 0;
  for (int k = 0; k < parts.count; ++k) {
    const Pass pass(table.planes[parts.first + k], table.plane_surfaces[parts.first + k], line);
    if (!(pass.approach > 0)) continue;
    const double t = pass.depth / pass.approach;
    if (t < out.t) out = {t, first_face + k};
  }
}

/// The round side of a sphere or a frustum.
Range Solids::round_range(const Parts& parts, const Line& line) const {
  const Range range = parts.kind == scene::BodyKind::sphere ? range_in(table.spheres[parts.round], line)
                                                            : range_in(table.cones[parts.round], line);
  return parts.round_surface == line.surface ? started(range, line.outward) : range;
}

std::optional<Span> Solids::span(int solid, const Line& line) const {
  const Parts& parts = table.parts[solid];
  Span span{{-infinity, -1}, {infinity, -1}};
  if (parts.round >= 0) {
    const Range range = round_range(parts, line);
    if (range.in >= range.out || range.out <= 0) return std::nullopt;
    if (range.in > span.in.t) span.in = {range.in, 0};
    if (range.out < span.out.t) span.out = {range.out, 0};
  }
  if (!clip(parts, line, span)) return std::nullopt;
  // Solids are bounded: a line without an end in one is not in it. Only faces that were given the surfaces of
  // others contradict each other so.
  if (span.in.face < 0 || span.out.face < 0) return std::nullopt;
  return span;
}

Crossing Solids::exit(int solid, const Line& line) const {
  const Parts& parts = table.parts[solid];
  Crossing out{infinity, 0};
  if (parts.round >= 0) out.t = round_range(parts, line).out;
  limit(parts, line, out);
  if (!(out.t < infinity)) return {0, out.face}; // nothing keeps it in: it has left
  return {std::max(out.t, 0.0), out.face};
}

std::optional<Crossing> Solids::crossing(int polygon, const Line& line) const {
  const Parts& parts = table.parts[polygon];
  const SolidTable::PlaneSurface& on = table.plane_surfaces[parts.first];
  if (on.surface == line.surface || (line.at_eye && on.under_eye)) return std::nullopt;
  const SolidTable::OutwardPlane& plane = table.planes[parts.first];
  const double approach = glm::dot(plane.normal, line.direction);
  const double t = (plane.offset - glm::dot(plane.normal, line.origin)) / approach;
  if (!(t > 0 && t < infinity)) return std::nullopt; // parallel lines too: infinite or not a number
  const Shear shear(line);
  bool inside = false;
  PlanePoint from = shear(table.corners[parts.corner + parts.corners - 1]);
  for (int k = parts.corner; k < parts.corner + parts.corners; ++k) {
    const PlanePoint to = shear(table.corners[k]);
    if (crosses_axis(from, to)) inside = !inside;
    from = to;
  }
  if (!inside) return std::nullopt;
  // Nearly along the plane t is rounding over rounding, but the polygon is where its corners are. Within
  // rounding of them t is left as it is, the same as for other faces on the surface.
  double nearest = infinity, farthest = -infinity;
  for (int k = parts.corner; k < parts.corner + parts.corners; ++k) {
    const double along = glm::dot(table.corners[k] - line.origin, line.direction);
    nearest = std::min(nearest, along);
    farthest = std::max(farthest, along);
  }
  const double margin = core::gamma(16) * (parts.reach + glm::length(line.origin));
  if (t > farthest + margin) return farthest > 0 ? std::optional(Crossing{farthest, 0}) : std::nullopt;
  return Crossing{t < nearest - margin ? nearest : t, 0};
}

} // namespace halftone::geometry
