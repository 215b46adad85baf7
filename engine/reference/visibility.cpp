#include "visibility.h"

#include <halftone/shade/fresnel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::reference {

namespace {

/// A glass boundary between point and light. t is measured from the point; the light's own direction runs
/// against it, so the light leaves a solid at in.t and enters it at out.t.
struct Boundary {
  double t = 0;
  int surface = -1;
  bool entered = false; ///< by the light on its way to the point
  Met met;
};

/// Whether `solid` is crossed before the light: the light is in it or not as a fact, so a span that reaches
/// past the light from outside ends, or begins, at the light.
std::optional<Span> cut_before_light(const World& world, int body, const Line& line, double distance,
                                     bool holds_light) {
  auto span = cut(world, world.bodies[body], line);
  if (!span || span->out.t <= 0) return std::nullopt;
  if (holds_light) {
    span->in.t = std::min(span->in.t, distance);
    span->out.t = std::numeric_limits<double>::infinity();
  } else if (span->out.t > distance) {
    if (span->in.t >= distance || distance - span->in.t < span->out.t - distance) return std::nullopt;
    span->out.t = distance;
  }
  return span;
}

/// Where the line leaves a solid by several faces at once, since the light is on an edge of it, it leaves by
/// the one that it meets at the smallest angle: that would be the last before a light a little off the edge.
Crossing exit_at_light(const World& world, const Body& solid, const PlacedLight& light, const Line& line,
                       double distance, const Crossing& out) {
  if (light.planes.size() < 2 || !is_in(light.planes, solid.faces[out.face].surface)) return out;
  Crossing last{distance, out.face};
  double least = 1;
  for (int f = 0; f < static_cast<int>(solid.faces.size()); ++f) {
    const scene::Face& face = solid.faces[f];
    if (!is_in(light.planes, face.surface)) continue;
    const double along =
        glm::dot(std::get<scene::Plane>(world.surfaces[face.surface]).normal, line.direction);
    const double outward = face.flipped ? -along : along;
    if (outward > 0 && outward < least) least = outward, last.face = f;
  }
  return last;
}

/// Whether a solid is behind the plane of a face in which the light lies, and the point before it.
bool is_behind(const World& world, const Body& solid, const PlacedLight& light, const Line& line) {
  return std::any_of(solid.faces.begin(), solid.faces.end(), [&](const scene::Face& face) {
    if (face.surface == line.surface || !is_in(light.planes, face.surface)) return false;
    const double height = height_over(world, world.surfaces[face.surface], line.origin).value;
    return face.flipped ? height < 0 : height > 0;
  });
}

} // namespace

std::vector<int> planes_through(const World& world, const Vec3& point) {
  std::vector<int> planes;
  for (int s = 0; s < static_cast<int>(world.surfaces.size()); ++s) {
    if (!std::holds_alternative<scene::Plane>(world.surfaces[s])) continue;
    const Height height = height_over(world, world.surfaces[s], point);
    if (std::abs(height.value) <= height.bound) planes.push_back(s);
  }
  return planes;
}

std::vector<int> polygons_through(const World& world, const Vec3& point) {
  std::vector<int> polygons;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    if (world.bodies[b].kind != scene::BodyKind::polygon) continue;
    const Height height = height_over(world, world.surfaces[world.bodies[b].faces[0].surface], point);
    if (std::abs(height.value) <= height.bound) polygons.push_back(b);
  }
  return polygons;
}

scene::Color visibility(const World& world, const PlacedLight& light, const Vec3& point, int surface,
                        int own) {
  const Vec3 to_light = light.light.position - point;
  const double distance = glm::length(to_light);
  Line line{point, to_light / distance, surface, false};
  line.outward = glm::dot(scene::normal_at(world.surfaces[surface], point), to_light) > 0;

  std::vector<Boundary> boundaries;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const Body& body = world.bodies[b];
    if (body.kind == scene::BodyKind::polygon) {
      if (is_in(light.polygons, b)) continue;
      const auto crossing = cross(world, body, line);
      if (crossing && crossing->t < distance) return scene::Color{0};
      continue;
    }
    const bool opaque = !world.materials[body.material].glass;
    if ((opaque && b == own) || (!light.planes.empty() && is_behind(world, body, light, line))) continue;
    auto span = cut_before_light(world, b, line, distance, is_in(light.around, b));
    if (!span) continue;
    if (!is_in(light.around, b)) span->out = exit_at_light(world, body, light, line, distance, span->out);
    const int in_surface = body.faces[span->in.face].surface;
    const int out_surface = body.faces[span->out.face].surface;
    const bool crosses_in = in_surface == surface || span->in.t > 0;
    const bool crosses_out = span->out.t <= distance;
    if (opaque) {
      if (in_surface == surface) continue; // touches the point
      if (crosses_in || crosses_out) return scene::Color{0};
      continue;
    }
    if (crosses_out) boundaries.push_back({span->out.t, out_surface, true, {b, span->out.face}});
    if (crosses_in) boundaries.push_back({span->in.t, in_surface, false, {b, span->in.face}});
  }

  std::sort(boundaries.begin(), boundaries.end(), [](const Boundary& a, const Boundary& b) {
    return a.t != b.t ? a.t > b.t : a.surface != b.surface ? a.surface < b.surface : a.entered < b.entered;
  });

  const auto index_in = [&](int body) {
    return body < 0 ? 1.0 : world.materials[world.bodies[body].material].glass->ior;
  };
  scene::Color visible{1};
  Inside inside = light.around;
  double at = distance;
  for (std::size_t i = 0; i < boundaries.size();) {
    // The exits, or the entries, of one surface at one distance.
    const Boundary& first = boundaries[i];
    std::vector<Met> together;
    for (; i < boundaries.size() && boundaries[i].t == first.t && boundaries[i].surface == first.surface &&
           boundaries[i].entered == first.entered;
         ++i)
      together.push_back(boundaries[i].met);
    const int before = medium(world, inside);
    if (before >= 0)
      visible *= shade::transmittance(world.materials[world.bodies[before].material].glass->absorption,
                                      at - first.t);
    at = first.t;
    inside = first.entered ? with(inside, together) : without(inside, together);
    const int after = medium(world, inside);
    if (after == before) continue;
    const int changed = first.entered ? after : before;
    const auto met =
        std::find_if(together.begin(), together.end(), [&](const Met& m) { return m.body == changed; });
    const int face_surface = world.bodies[changed].faces[met->face].surface;
    const Vec3 normal = scene::normal_at(world.surfaces[face_surface], line.at(first.t));
    const double cosine = std::min(1.0, std::abs(glm::dot(normal, line.direction)));
    visible *= 1 - shade::fresnel_reflectance(cosine, index_in(before), index_in(after));
    if (visible == core::black) return visible;
  }
  const int last = medium(world, inside);
  if (last >= 0)
    visible *= shade::transmittance(world.materials[world.bodies[last].material].glass->absorption, at);
  return visible;
}

} // namespace halftone::reference
