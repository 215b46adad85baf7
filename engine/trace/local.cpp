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

/// What a ray sees of a face.
struct Face {
  Face(const Prepared& prepared, const Met& met)
      : body(prepared.world.bodies[met.body]),
        face(body.faces[met.face]),
        surface(prepared.world.surfaces[face.surface]) {}

  const scene::Body& body;
  const scene::Face& face;
  const scene::Surface& surface;

  /// The face's own normal, on the ray's side.
  Vec3 own_normal(const Ray& ray) const {
    const Vec3 normal = scene::normal_at(surface, ray.origin);
    return ray.outward ? -normal : normal;
  }

  /// That of the shape which the face stands for.
  Vec3 normal(const Ray& ray, const Vec3& own) const {
    if (!face.rounded) return own;
    const Vec3 round = scene::normal_at(*body.round, ray.origin);
    return glm::dot(round, ray.direction) > 0 ? -round : round;
  }
};

/// The lights' terms without what stands in their way, and the shadow rays.
void shade(const Prepared& prepared, const Ray& ray, const Face& seen, std::size_t k, LocalScratch& scratch,
           Local& local, Sample& sample) {
  const scene::Material& material = prepared.world.materials[seen.body.material];
  const Vec3 own = seen.own_normal(ray);
  const auto cell = shade::cell(material, seen.face, ray.origin, own);
  const shade::SurfacePoint point{
      ray.origin,        ray.direction,     seen.normal(ray, own), shade::albedo(material, cell),
      material.specular, material.shininess};
  local = {point.albedo * prepared.world.ambient, cell ? signature_of(*cell) : 0, point.normal};
  if (point.albedo == core::black && point.specular == core::black) return;
  for (std::size_t light = 0; light < prepared.lights.size(); ++light) {
    const PlacedLight& placed = prepared.lights[light];
    if (!shade::faces(point, placed.light) || (!seen.face.rounded && placed.lies_in(ray.surface))) continue;
    const core::Color direct = shade::direct_light(point, placed.light);
    if (direct == core::black) { // no shadow of it can be seen
      local.facts += unshadowed(static_cast<int>(light));
      continue;
    }
    scratch.to_light[light].of.push_back(k);
    scratch.to_light[light].light.push_back(direct);
    ++sample.rays;
  }
}

} // namespace

void shade_seen(const Prepared& prepared, std::span<const Ray> rays, std::span<const Seen> seen,
                LocalScratch& scratch, std::span<Local> local, std::span<Sample> samples, Counts& counts) {
  scratch.to_light.resize(prepared.lights.size());
  for (ShadowRays& shadow_rays : scratch.to_light) {
    shadow_rays.of.clear();
    shadow_rays.light.clear();
  }

  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (seen[k].kind == SeenKind::nothing) continue;
    const Ray& ray = rays[k];
    const Face face(prepared, seen[k].met);
    if (seen[k].kind == SeenKind::leaving)
      local[k] = {core::black, 0, face.normal(ray, face.own_normal(ray))};
    else
      shade(prepared, ray, face, k, scratch, local[k], samples[ray.sample]);
  }

  for (std::size_t light = 0; light < prepared.lights.size(); ++light) {
    const ShadowRays& shadow_rays = scratch.to_light[light];
    counts.shadow += shadow_rays.of.size();
    scratch.lit.clear();
    for (const std::size_t k : shadow_rays.of)
      scratch.lit.push_back({rays[k].origin, rays[k].surface, seen[k].met.body});
    scratch.visible.resize(scratch.lit.size());
    visibilities(prepared, static_cast<int>(light), scratch.lit, scratch.shadow, scratch.visible);
    for (std::size_t s = 0; s < shadow_rays.of.size(); ++s) {
      Local& lit = local[shadow_rays.of[s]];
      lit.radiance += scratch.visible[s].value * shadow_rays.light[s];
      lit.facts += scratch.visible[s].signature;
    }
  }
}

} // namespace halftone::trace
