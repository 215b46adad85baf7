// Transparent shadows as Tadamura, Nakamae, Nishita (c. 1986, section 3.4.3) have them, C =
// (1-ra)(1-rb)(1-t), for any number of nested and touching solids: opaque casters first, since one of them
// ends the question; then the boundaries of the glass, sorted along the way of the light, those on one
// surface at one distance together.
//
// Invariant: a point does not shadow itself, by fact: the opaque body that it lies on and opaque bodies that
// begin on its surface do not count.

#include "visibility.h"

#include "signature.h"

#include <halftone/core/rounding.h>
#include <halftone/shade/fresnel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halftone::trace {

namespace {

constexpr Visible blocked{core::black, 0};

/// The way from a point to a light.
struct Segment {
  geometry::Line line;
  double distance = 0;
  int own = -1; ///< the body that the point lies on
  const PlacedLight& light;
};

// inline here and below: g++ would call what several callers have for every shadow ray.
inline Segment segment_to(const Prepared& prepared, int light, const LitPoint& point) {
  const PlacedLight& placed = prepared.lights[light];
  const Vec3 to_light = placed.light.position - point.position;
  const double distance = glm::length(to_light);
  const Vec3 normal = scene::normal_at(prepared.world.surfaces[point.surface], point.position);
  return {{point.position, to_light / distance, point.surface, glm::dot(normal, to_light) > 0},
          distance,
          point.body,
          placed};
}

/// Whether the light lies in the plane of a face that the point is before: then all of the segment is before
/// it, and the solid begins at the light, if it meets the line. The span may say otherwise where the line
/// touches an edge that the light is on, and the span is nothing but rounding.
bool begins_at_light(const Prepared& prepared, const Segment& segment, int body) {
  if (segment.light.planes.empty()) return false;
  const std::vector<scene::Face>& faces = prepared.world.bodies[body].faces;
  return std::any_of(faces.begin(), faces.end(), [&](const scene::Face& face) {
    if (face.surface == segment.line.surface || !segment.light.lies_in(face.surface)) return false;
    const auto& plane = std::get<scene::Plane>(prepared.world.surfaces[face.surface]);
    const double height = glm::dot(plane.normal, segment.line.origin) - plane.offset;
    return face.flipped ? height < 0 : height > 0;
  });
}

/// A light on an edge of a solid lies in the planes of several faces, all of which the line leaves by at
/// once. It leaves by the one that it meets at the smallest angle: that would be the last before a light that
/// is as far off all of them, however near, and its reflectance changes steadily along the edge.
geometry::Crossing exit_at_light(const Prepared& prepared, const Segment& segment, int body,
                                 const geometry::Crossing& out) {
  const std::vector<scene::Face>& faces = prepared.world.bodies[body].faces;
  if (segment.light.planes.size() < 2 || !segment.light.lies_in(faces[out.face].surface)) return out;
  geometry::Crossing last{segment.distance, out.face};
  double least = 1;
  for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
    if (!segment.light.lies_in(faces[face].surface)) continue;
    const auto& plane = std::get<scene::Plane>(prepared.world.surfaces[faces[face].surface]);
    const double along = glm::dot(plane.normal, segment.line.direction);
    const double outward = faces[face].flipped ? -along : along;
    if (outward > 0 && outward < least) {
      least = outward;
      last.face = face;
    }
  }
  return last;
}

/// The part of a solid before the light, of where its line runs in it. The light is in the solid or not as a
/// fact, so a span that reaches past the light from outside ends, or begins, at the light.
inline std::optional<geometry::Span> before_light(const Prepared& prepared, const Segment& segment, int body,
                                                  std::optional<geometry::Span> span) {
  if (!span || begins_at_light(prepared, segment, body)) return std::nullopt;
  const std::vector<int>& around = segment.light.around;
  if (std::binary_search(around.begin(), around.end(), body)) {
    span->in.t = std::min(span->in.t, segment.distance);
    span->out.t = std::numeric_limits<double>::infinity();
    return span;
  }
  if (span->out.t > segment.distance) {
    const double before = segment.distance - span->in.t, behind = span->out.t - segment.distance;
    if (before <= 0 || before < behind) return std::nullopt;
    span->out.t = segment.distance;
  }
  span->out = exit_at_light(prepared, segment, body, span->out);
  return span;
}

int surface_of(const Prepared& prepared, int body, const geometry::Crossing& crossing) {
  return prepared.world.bodies[body].faces[crossing.face].surface;
}

/// The same for packets of lines: shade() in geometry/packet.cpp, where the light lies in no body and no
/// plane.
bool is_blocked_by(const Prepared& prepared, const Segment& segment, int opaque) {
  if (opaque == segment.own) return false;
  if (prepared.is_polygon(opaque)) {
    const auto crossing = prepared.solids.crossing(opaque, segment.line);
    return crossing && crossing->t < segment.distance;
  }
  const auto span = before_light(prepared, segment, opaque, prepared.solids.span(opaque, segment.line));
  if (!span || surface_of(prepared, opaque, span->in) == segment.line.surface) return false;
  return span->in.t > 0 || span->out.t <= segment.distance;
}

/// runs: where the segment's line runs in the solid.
inline void add_boundaries(const Prepared& prepared, const Segment& segment, int glass,
                           const std::optional<geometry::Span>& runs,
                           std::pmr::vector<Boundary>& boundaries) {
  const auto span = before_light(prepared, segment, glass, runs);
  if (!span) return;
  const int in_surface = surface_of(prepared, glass, span->in);
  if (span->out.t <= segment.distance)
    boundaries.push_back(
        {span->out.t, surface_of(prepared, glass, span->out), true, {glass, span->out.face}});
  if (span->in.t > 0 || in_surface == segment.line.surface)
    boundaries.push_back({span->in.t, in_surface, false, {glass, span->in.face}});
}

/// Solids that the light's ray is in, with those that it enters or without those that it leaves.
void cross(std::pmr::vector<int>& inside, std::span<const Boundary> together) {
  for (const Boundary& boundary : together) {
    const int body = boundary.met.body;
    const auto place = std::lower_bound(inside.begin(), inside.end(), body);
    if (boundary.entered)
      inside.insert(place, body);
    else if (place != inside.end() && *place == body)
      inside.erase(place);
  }
}

Visible through_glass(const Prepared& prepared, const Segment& segment, GlassScratch& scratch) {
  std::pmr::vector<Boundary>& boundaries = scratch.boundaries;
  std::sort(boundaries.begin(), boundaries.end(), [](const Boundary& a, const Boundary& b) {
    if (a.t != b.t) return a.t > b.t;
    return a.surface != b.surface ? a.surface < b.surface : a.entered < b.entered;
  });
  std::pmr::vector<int>& inside = scratch.inside;
  inside.clear();
  std::copy_if(segment.light.around.begin(), segment.light.around.end(), std::back_inserter(inside),
               [&](int body) { return prepared.media[body].is_glass; });
  const auto medium = [&] { return inside.empty() ? -1 : inside.back(); };

  Visible visible{core::Color{1}, 0};
  double at = segment.distance;
  for (std::size_t i = 0; i < boundaries.size();) {
    const Boundary first = boundaries[i];
    std::size_t end = i;
    while (end < boundaries.size() && boundaries[end].t == first.t &&
           boundaries[end].surface == first.surface && boundaries[end].entered == first.entered)
      ++end;
    const std::span<const Boundary> together{boundaries.data() + i, end - i};
    i = end;

    const int before = medium();
    visible.value *= prepared.transmittance(before, at - first.t);
    at = first.t;
    cross(inside, together);
    const int after = medium();
    if (after == before) continue;
    const int changed = first.entered ? after : before;
    const auto met = std::find_if(together.begin(), together.end(),
                                  [&](const Boundary& b) { return b.met.body == changed; });
    const Vec3 normal = scene::normal_at(prepared.world.surfaces[first.surface], segment.line.at(first.t));
    const double cosine = std::min(1.0, std::abs(glm::dot(normal, segment.line.direction)));
    visible.value *=
        1 - shade::fresnel_reflectance(cosine, prepared.media[before].index, prepared.media[after].index);
    if (visible.value == core::black) return blocked;
    visible.signature += mixed(mixed(pair_of(changed, met->met.face)) + (first.entered ? 1 : 0));
  }
  visible.value *= prepared.transmittance(medium(), at);
  return visible;
}

/// An opaque body that blocks the segment, or -1; then all boundaries of glass on it are added.
int look_at_all(const Prepared& prepared, const Segment& segment, ShadowScratch& scratch) {
  scratch.comparisons += prepared.world.bodies.size();
  const auto found = segment.light.casters.gather(-segment.line.direction, segment.distance, scratch.casters);
  for (const int* body = found.opaque; body != found.glass; ++body)
    if (is_blocked_by(prepared, segment, *body)) return *body;
  for (const int* body = found.glass; body != found.end; ++body)
    add_boundaries(prepared, segment, *body, prepared.solids.span(*body, segment.line),
                   scratch.glass.boundaries);
  return -1;
}

/// The same, by the hierarchy.
int look_in_tree(const Prepared& prepared, const Segment& segment, ShadowScratch& scratch) {
  const geometry::Line& line = segment.line;
  const double limit = segment.distance * (1 + core::gamma(16));
  int blocking = -1;
  prepared.tree->along({line.origin, line.direction}, limit, [&](int body) {
    ++scratch.comparisons;
    if (!segment.light.casters.include(body) || !prepared.balls.may_meet(body, line)) return limit;
    if (prepared.media[body].is_glass)
      add_boundaries(prepared, segment, body, prepared.solids.span(body, segment.line),
                     scratch.glass.boundaries);
    else if (is_blocked_by(prepared, segment, body))
      blocking = body;
    return blocking < 0 ? limit : -1.0;
  });
  return blocking;
}

/// The light's signature, from the sum over the boundaries that it crosses.
Visible signed_by(int light, Visible visible) {
  visible.signature = mixed(mixed(static_cast<std::uint64_t>(light) + 1) + visible.signature);
  return visible;
}

/// By way of the boundaries that were found.
Visible seen_through(const Prepared& prepared, const Segment& segment, int light, GlassScratch& scratch) {
  if (scratch.boundaries.empty() && segment.light.around.empty()) return {core::Color{1}, unshadowed(light)};
  const Visible visible = through_glass(prepared, segment, scratch);
  return visible.value == core::black ? blocked : signed_by(light, visible);
}

} // namespace

std::uint64_t unshadowed(int light) { return signed_by(light, Visible{}).signature; }

Visible visibility(const Prepared& prepared, int light, const LitPoint& point, ShadowScratch& scratch) {
  const Segment segment = segment_to(prepared, light, point);
  scratch.blockers.resize(prepared.lights.size(), -1);
  int& blocker = scratch.blockers[light];
  if (blocker >= 0 && is_blocked_by(prepared, segment, blocker)) return blocked;
  scratch.glass.boundaries.clear();
  const int blocking =
      prepared.tree ? look_in_tree(prepared, segment, scratch) : look_at_all(prepared, segment, scratch);
  if (blocking >= 0) {
    blocker = blocking;
    return blocked;
  }
  return seen_through(prepared, segment, light, scratch.glass);
}

namespace {

/// More bodies than this are not asked for a packet where there is a hierarchy.
constexpr std::size_t most_together = 64;

void visibilities_alone(const Prepared& prepared, int light, std::span<const LitPoint> points,
                        ShadowScratch& scratch, std::span<Visible> result) {
  for (std::size_t k = 0; k < points.size(); ++k) result[k] = visibility(prepared, light, points[k], scratch);
}

/// Up to packet_size points at once. Those of which the packet is not sure are asked again one by one.
void visibilities_together(const Prepared& prepared, int light, std::span<const LitPoint> points,
                           ShadowScratch& scratch, std::span<Visible> result) {
  const PlacedLight& placed = prepared.lights[light];
  std::array<std::optional<Segment>, geometry::packet_size> segments;
  geometry::Packet& packet = scratch.packet;
  geometry::Obstacles& obstacles = scratch.obstacles;
  geometry::Bounds directions;
  for (std::size_t k = 0; k < geometry::packet_size; ++k) {
    const Segment& segment =
        segments[k].emplace(segment_to(prepared, light, points[std::min(k, points.size() - 1)]));
    packet.set(k, segment.line);
    obstacles.distance[k] = segment.distance;
    obstacles.own[k] = segment.own;
    directions.include({-segment.line.direction, -segment.line.direction});
  }
  const Casters::Lists& near = scratch.near;
  placed.casters.gather(directions, scratch.near);
  if (prepared.tree && near.size() > most_together) {
    visibilities_alone(prepared, light, points, scratch, result);
    return;
  }
  prepared.packets->shade(packet, near.opaque, near.glass, obstacles);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto has = [&](geometry::Lines lines) { return (lines >> k & 1) != 0; };
    if (has(obstacles.unsure)) {
      result[k] = visibility(prepared, light, points[k], scratch);
      continue;
    }
    scratch.comparisons += near.size();
    result[k] = blocked;
    if (has(obstacles.blocked)) continue;
    scratch.glass.boundaries.clear();
    for (std::size_t g = 0; g < near.glass.size(); ++g)
      if (has(obstacles.glass[g].lines))
        add_boundaries(prepared, *segments[k], near.glass[g], obstacles.glass[g][k],
                       scratch.glass.boundaries);
    result[k] = seen_through(prepared, *segments[k], light, scratch.glass);
  }
}

} // namespace

void visibilities(const Prepared& prepared, int light, std::span<const LitPoint> points,
                  ShadowScratch& scratch, std::span<Visible> result) {
  const PlacedLight& placed = prepared.lights[light];
  if (!prepared.packets || !placed.planes.empty() || !placed.around.empty()) {
    visibilities_alone(prepared, light, points, scratch, result);
    return;
  }
  for (std::size_t first = 0; first < points.size(); first += geometry::packet_size) {
    const std::size_t count = std::min(geometry::packet_size, points.size() - first);
    visibilities_together(prepared, light, points.subspan(first, count), scratch,
                          result.subspan(first, count));
  }
}

Visible visibility(const Prepared& prepared, int light, const LitPoint& point, std::span<const int> casters,
                   GlassScratch& scratch) {
  const Segment segment = segment_to(prepared, light, point);
  const std::vector<int>& in_plane = segment.light.in_plane;
  scratch.boundaries.clear();
  for (const int body : casters) {
    if (prepared.media[body].is_glass)
      add_boundaries(prepared, segment, body, prepared.solids.span(body, segment.line), scratch.boundaries);
    else if (!std::binary_search(in_plane.begin(), in_plane.end(), body) &&
             is_blocked_by(prepared, segment, body))
      return blocked;
  }
  const Visible visible = through_glass(prepared, segment, scratch);
  return visible.value == core::black ? blocked : signed_by(light, visible);
}

} // namespace halftone::trace
