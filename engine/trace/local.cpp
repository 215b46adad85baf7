// The local terms of the scene format's section 3. Shadow rays are collected light by light, so that each
// light's casters are walked with the same things at hand; a light whose terms are black at a point casts
// none.
//
// A light in the plane of a flat face has n . l = 0 there as a fact: what is calculated is rounding of either
// sign, and a highlight does not depend on how small it is.
//
// Invariant: a point's terms are added in the order of the lights, whatever else is in the slice.

#include "local.h"

#include "signature.h"

namespace halftone::trace {

namespace {

shade::SurfacePoint surface_point(const Prepared& prepared, const Rays& rays, std::size_t ray, const Met& met,
                                  std::uint64_t& facts) {
  const scene::Body& body = prepared.world.bodies[met.body];
  const scene::Face& face = body.faces[met.face];
  const scene::Material& material = prepared.world.materials[body.material];
  shade::SurfacePoint point;
  point.position = rays.origin(ray);
  point.direction = rays.direction(ray);
  point.normal = scene::normal_at(prepared.world.surfaces[face.surface], point.position);
  if (rays.outward[ray]) point.normal = -point.normal;
  const auto cell = shade::cell(material, face, point.position, point.normal);
  if (cell) facts += signature_of(*cell);
  point.albedo = shade::albedo(material, cell);
  point.specular = material.specular;
  point.shininess = material.shininess;
  if (face.rounded) {
    point.normal = scene::normal_at(*body.round, point.position);
    if (glm::dot(point.normal, point.direction) > 0) point.normal = -point.normal;
  }
  return point;
}

} // namespace

void shade_seen(const Prepared& prepared, const Rays& rays, Slice slice, const Seen& seen,
                LocalScratch& scratch, Local& local, std::span<Sample> samples, Counts& counts) {
  local.points.resize(slice.size());
  local.radiance.assign(slice.size(), core::black);
  local.facts.assign(slice.size(), 0);
  scratch.to_light.resize(prepared.lights.size());
  for (ShadowRays& shadow_rays : scratch.to_light) {
    shadow_rays.of.clear();
    shadow_rays.light.clear();
  }

  for (std::size_t k = 0; k < slice.size(); ++k) {
    if (seen.kind[k] == SeenKind::nothing) continue;
    const std::size_t ray = slice.begin + k;
    shade::SurfacePoint& point = local.points[k];
    std::uint64_t facts = 0;
    point = surface_point(prepared, rays, ray, seen.met[k], facts);
    if (seen.kind[k] == SeenKind::leaving) continue;
    local.facts[k] = facts;
    local.radiance[k] = point.albedo * prepared.world.ambient;
    if (point.albedo == core::black && point.specular == core::black) continue;
    const Met& met = seen.met[k];
    const bool is_flat = !prepared.world.bodies[met.body].faces[met.face].rounded;
    for (std::size_t light = 0; light < prepared.lights.size(); ++light) {
      if (!shade::faces(point, prepared.lights[light].light) ||
          (is_flat && prepared.lights[light].lies_in(rays.surface[ray])))
        continue;
      const core::Color direct = shade::direct_light(point, prepared.lights[light].light);
      if (direct == core::black) { // no shadow of it can be seen
        local.facts[k] += unshadowed(static_cast<int>(light));
        continue;
      }
      scratch.to_light[light].of.push_back(k);
      scratch.to_light[light].light.push_back(direct);
      ++samples[rays.sample[ray]].rays;
    }
  }

  for (std::size_t light = 0; light < prepared.lights.size(); ++light) {
    const ShadowRays& shadow_rays = scratch.to_light[light];
    counts.shadow += shadow_rays.of.size();
    scratch.lit.clear();
    for (const std::size_t k : shadow_rays.of)
      scratch.lit.push_back({local.points[k].position, rays.surface[slice.begin + k], seen.met[k].body});
    scratch.visible.resize(scratch.lit.size());
    visibilities(prepared, static_cast<int>(light), scratch.lit, scratch.shadow, scratch.visible);
    for (std::size_t s = 0; s < shadow_rays.of.size(); ++s) {
      const std::size_t k = shadow_rays.of[s];
      local.radiance[k] += scratch.visible[s].value * shadow_rays.light[s];
      local.facts[k] += scratch.visible[s].signature;
    }
  }
}

} // namespace halftone::trace
