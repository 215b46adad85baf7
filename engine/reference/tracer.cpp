// T. Whitted, "An improved illumination model for shaded display" (1980), with the exact Fresnel terms,
// nested dielectrics by priority (C. Schmidt and B. Budge, "Simple nested dielectrics in ray traced images",
// 2002) and contact decided by shared surfaces. Colour is the sum over the tree of weight times local term.

#include "tracer.h"

#include <halftone/shade/albedo.h>
#include <halftone/shade/fresnel.h>

#include <algorithm>

namespace halftone::reference {

scene::Color Tracer::eye_ray(const Vec3& direction) {
  sum_ = scene::Color{0};
  ++counts_.eye;
  Ray ray;
  ray.line = {world_.camera.eye, direction, eye_.surface, false, true};
  ray.inside = eye_.around;
  if (eye_.surface >= 0) { // in the gap on that surface
    const Vec3 normal = scene::normal_at(world_.surfaces[eye_.surface], world_.camera.eye);
    ray.line.outward = glm::dot(normal, direction) > 0;
    Line turned = ray.line;
    turned.direction = -direction;
    turned.outward = !ray.line.outward;
    ray.gap = Gap{touching(world_, ray.line), touching(world_, turned)};
  }
  follow(std::move(ray));
  return sum_;
}

void Tracer::spawn(Ray ray, std::uint64_t& count) {
  ++ray.depth;
  if (ray.depth > world_.trace.depth || core::max_component(ray.weight) < world_.trace.cutoff) return;
  ++count;
  follow(std::move(ray));
}

void Tracer::follow(Ray ray) {
  do { // as often as a boundary is not seen
    if (!ray.gap && !advance(ray)) return;
  } while (!meet_in_gap(ray));
}

/// To the gap on the next surface at which something is seen or entered; false if the ray ends before it.
bool Tracer::advance(Ray& ray) {
  while (!ray.gap) {
    const auto meeting = next_meeting(world_, ray.line, ray.inside);
    if (!meeting) {
      sum_ += ray.weight * world_.background;
      return false;
    }
    const int before = medium(world_, ray.inside);
    if (before >= 0) ray.weight *= shade::transmittance(material_of(before).glass->absorption, meeting->t);
    const Vec3 point = ray.line.at(meeting->t);
    ray.line = {point, ray.line.direction, meeting->surface, meeting->outward, point == world_.camera.eye};

    Inside after_exits = without(ray.inside, meeting->exits);
    Gap gap{meeting->ahead, {{}, meeting->exits}};
    if (medium(world_, after_exits) != before) {
      const auto left = std::find_if(meeting->exits.begin(), meeting->exits.end(),
                                     [&](const Met& met) { return met.body == before; });
      refract_or_reflect(ray, *left, std::move(after_exits), std::nullopt, std::move(gap));
      return false;
    }
    ray.inside = std::move(after_exits);
    ray.gap = std::move(gap);
  }
  return true;
}

/// The second and third step at a surface: an opaque surface ends the ray, otherwise all entries, together.
/// True if the ray ends; else it is behind the surface, in the same medium.
bool Tracer::meet_in_gap(Ray& ray) {
  const Gap gap = *std::move(ray.gap);
  ray.gap.reset();
  const Gap turned{gap.behind, gap.ahead};
  if (gap.ahead.opaque.body >= 0) {
    add_local_terms(ray, gap.ahead.opaque);
    const scene::Color& mirror = material_of(gap.ahead.opaque.body).mirror;
    if (mirror == core::black) return true;
    const shade::SurfacePoint point = surface_point(ray, gap.ahead.opaque);
    Ray reflected = ray;
    reflected.line.direction = shade::reflect(ray.line.direction, point.normal);
    reflected.line.outward = !ray.line.outward;
    reflected.weight *= mirror;
    reflected.gap = turned;
    spawn(std::move(reflected), counts_.reflected);
    return true;
  }
  const int before = medium(world_, ray.inside);
  Inside after_entries = with(ray.inside, gap.ahead.entries);
  const int after = medium(world_, after_entries);
  if (after == before) {
    ray.inside = std::move(after_entries);
    return false;
  }
  const auto entered = std::find_if(gap.ahead.entries.begin(), gap.ahead.entries.end(),
                                    [&](const Met& met) { return met.body == after; });
  add_local_terms(ray, *entered);
  refract_or_reflect(ray, *entered, std::move(after_entries), turned, std::nullopt);
  return true;
}

/// The boundary between the media of ray.inside and `behind`.
void Tracer::refract_or_reflect(const Ray& ray, const Met& boundary, Inside behind,
                                std::optional<Gap> reflected_in, std::optional<Gap> refracted_in) {
  const double n1 = index_in(medium(world_, ray.inside));
  const double n2 = index_in(medium(world_, behind));
  const Vec3 normal = surface_point(ray, boundary).normal;
  const Vec3& direction = ray.line.direction;
  const auto bent = shade::refract(direction, normal, n1, n2);
  const double cosine = std::clamp(-glm::dot(direction, normal), 0.0, 1.0);
  const double reflectance = bent ? shade::fresnel_reflectance(cosine, n1, n2) : 1;

  Ray reflected = ray;
  reflected.line.direction = shade::reflect(direction, normal);
  reflected.line.outward = !ray.line.outward;
  reflected.weight *= reflectance;
  reflected.gap = std::move(reflected_in);
  spawn(std::move(reflected), counts_.reflected);

  if (!bent) return;
  Ray refracted = ray;
  refracted.line.direction = *bent;
  refracted.inside = std::move(behind);
  refracted.weight *= 1 - reflectance;
  refracted.gap = std::move(refracted_in);
  spawn(std::move(refracted), counts_.refracted);
}

shade::SurfacePoint Tracer::surface_point(const Ray& ray, const Met& met) const {
  const Body& body = world_.bodies[met.body];
  const scene::Face& face = body.faces[met.face];
  const scene::Material& material = world_.materials[body.material];
  shade::SurfacePoint point;
  point.position = ray.line.origin;
  point.direction = ray.line.direction;
  point.normal = scene::normal_at(world_.surfaces[face.surface], point.position);
  if (ray.line.outward) point.normal = -point.normal;
  point.albedo = shade::albedo(material, shade::cell(material, face, point.position, point.normal));
  point.specular = material.specular;
  point.shininess = material.shininess;
  if (face.rounded) {
    point.normal = scene::normal_at(*body.round, point.position);
    if (glm::dot(point.normal, point.direction) > 0) point.normal = -point.normal;
  }
  return point;
}

void Tracer::add_local_terms(const Ray& ray, const Met& met) {
  const shade::SurfacePoint point = surface_point(ray, met);
  scene::Color local = point.albedo * world_.ambient;
  for (const PlacedLight& light : lights_) {
    if (!shade::faces(point, light.light)) continue;
    // n . l = 0, which rounding may make positive.
    if (is_in(light.planes, ray.line.surface) && !world_.bodies[met.body].faces[met.face].rounded) continue;
    ++counts_.shadow;
    const scene::Color visible = visibility(world_, light, point.position, ray.line.surface, met.body);
    if (visible != core::black) local += visible * shade::direct_light(point, light.light);
  }
  sum_ += ray.weight * local;
}

} // namespace halftone::reference
