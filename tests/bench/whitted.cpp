// T. Whitted, "An improved illumination model for shaded display" (1980), with exact Fresnel terms, nested
// dielectrics by priority (C. Schmidt and B. Budge, 2002) and straight shadow rays through glass. Coincident
// surfaces are met in the order of their distances as computed, which is the noise that contact means here.

#include "whitted.h"

#include <halftone/shade/albedo.h>
#include <halftone/shade/fresnel.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halftone::bench {

namespace {

Vec3 turned_to_face(const Vec3& normal, const Vec3& direction) {
  return glm::dot(normal, direction) > 0 ? -normal : normal;
}

} // namespace

Whitted::Whitted(const scene::World& world, const EmbreeScene& scene)
    : world_(world),
      scene_(scene),
      around_eye_(scene.solids_around(world.camera.eye)) {
  for (const scene::Light& light : world.lights)
    lights_.push_back({light, scene.solids_around(light.position)});
}

core::Color Whitted::radiance(double x, double y) const {
  core::Color sum{0};
  Ray ray;
  ray.line = {world_.camera.eye, world_.camera.direction(x, y)};
  ray.inside = around_eye_;
  follow(ray, sum);
  return sum;
}

/// The glass solid of the set that stands last in the file, or -1 for air.
int Whitted::medium(const InsideSet& inside) const {
  int last = -1;
  for (const int body : inside.all())
    if (body > last && material_of(body).glass) last = body;
  return last;
}

void Whitted::spawn(Ray ray, core::Color& sum) const {
  ++ray.depth;
  if (ray.depth > world_.trace.depth || core::max_component(ray.weight) < world_.trace.cutoff) return;
  follow(ray, sum);
}

void Whitted::follow(Ray ray, core::Color& sum) const {
  for (;;) { // as often as a boundary is not seen
    const Hit hit = scene_.nearest(ray.line, ray.start, ray.inside);
    if (hit.body < 0) {
      sum += ray.weight * world_.background;
      return;
    }
    const int before = medium(ray.inside);
    if (before >= 0) ray.weight *= shade::transmittance(material_of(before).glass->absorption, hit.t);

    Seen seen;
    seen.body = hit.body;
    seen.face = hit.face;
    seen.position = ray.line.origin + hit.t * ray.line.direction;
    const scene::Body& body = world_.bodies[hit.body];
    seen.normal = turned_to_face(
        scene::normal_at(world_.surfaces[body.faces[hit.face].surface], seen.position), ray.line.direction);
    ray.line.origin = seen.position;

    const scene::Material& material = world_.materials[body.material];
    if (!material.glass) {
      add_local(ray, seen, sum);
      if (material.mirror == core::black) return;
      Ray reflected = ray;
      reflected.start = hit.body;
      reflected.line.direction = shade::reflect(ray.line.direction, seen.normal); // no stand-in is a mirror
      reflected.weight *= material.mirror;
      spawn(reflected, sum);
      return;
    }

    InsideSet behind = ray.inside;
    const bool leaves = ray.inside.has(hit.body);
    if (leaves)
      behind.remove(hit.body);
    else
      behind.add(hit.body);
    ray.start = hit.body;
    if (medium(behind) == before) {
      ray.inside = behind;
      continue;
    }
    if (!leaves) add_local(ray, seen, sum);
    branch(ray, seen, behind, sum);
    return;
  }
}

void Whitted::branch(const Ray& ray, const Seen& seen, const InsideSet& behind, core::Color& sum) const {
  const double n1 = index_in(medium(ray.inside)), n2 = index_in(medium(behind));
  const Vec3& direction = ray.line.direction;
  const double reflectance =
      shade::fresnel_reflectance(std::clamp(-glm::dot(direction, seen.normal), 0.0, 1.0), n1, n2);
  Ray reflected = ray;
  reflected.line.direction = shade::reflect(direction, seen.normal);
  reflected.weight *= reflectance;
  spawn(reflected, sum);
  const auto bent = shade::refract(direction, seen.normal, n1, n2);
  if (!bent) return;
  Ray refracted = ray;
  refracted.line.direction = *bent;
  refracted.inside = behind;
  refracted.weight *= 1 - reflectance;
  spawn(refracted, sum);
}

void Whitted::add_local(const Ray& ray, const Seen& seen, core::Color& sum) const {
  const scene::Body& body = world_.bodies[seen.body];
  const scene::Face& face = body.faces[seen.face];
  const scene::Material& material = world_.materials[body.material];
  const core::Color albedo = shade::albedo(material, shade::cell(material, face, seen.position, seen.normal));
  const bool has_highlight = material.specular != core::black;
  core::Color local = albedo * world_.ambient;
  if (albedo != core::black || has_highlight) {
    const Vec3 normal = face.rounded
                            ? turned_to_face(scene::normal_at(*body.round, seen.position), ray.line.direction)
                            : seen.normal;
    for (const PlacedLight& light : lights_) {
      const Vec3 to_light = light.light.position - seen.position;
      const double height = glm::dot(normal, to_light);
      if (height <= 0) continue;
      const double distance = glm::length(to_light), n_l = height / distance;
      const Line line{seen.position, to_light * (1 / distance)};
      core::Color direct = albedo * n_l;
      const double r_v = -glm::dot(normal * (2 * n_l) - line.direction, ray.line.direction);
      if (has_highlight && r_v > 0) direct += material.specular * std::pow(r_v, material.shininess);
      direct *= light.light.color;
      // What adds less than 2^-16 to the ray's radiance is not worth a shadow ray.
      if (core::max_component(direct * ray.weight) < 1.0 / 65536 || scene_.is_dark(line, distance, seen.body))
        continue;
      if (scene_.has_glass()) direct *= through_glass(light, line, distance, seen.body);
      local += direct;
    }
  }
  sum += ray.weight * local;
}

/// Along the straight line, from the light to the point.
core::Color Whitted::through_glass(const PlacedLight& light, const Line& line, double distance,
                                   int start) const {
  struct Crossing {
    double t = 0;
    int body = -1;
    int face = -1;
    bool entered = false; ///< by the light on its way
  };
  const auto spans = scene_.glass_between(line, distance, start);
  if (spans.empty()) return core::Color{1};
  std::array<Crossing, 64> crossings;
  std::size_t count = 0;
  for (const GlassSpan& glass : spans) {
    if (count + 2 > crossings.size()) break;
    // The light is in it or not as a fact.
    if (!light.around.has(glass.body))
      crossings[count++] = {std::min(glass.span.out, distance), glass.body, glass.span.out_face, true};
    if (glass.span.in > 0) crossings[count++] = {glass.span.in, glass.body, glass.span.in_face, false};
  }
  std::sort(
      crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(count),
      [](const Crossing& a, const Crossing& b) { return a.t != b.t ? a.t > b.t : a.entered < b.entered; });
  core::Color visible{1};
  InsideSet inside = light.around;
  double at = distance;
  const auto absorb = [&](int body, double length) {
    if (body >= 0) visible *= shade::transmittance(material_of(body).glass->absorption, length);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Crossing& crossing = crossings[i];
    const int before = medium(inside);
    absorb(before, at - crossing.t);
    at = crossing.t;
    if (crossing.entered)
      inside.add(crossing.body);
    else
      inside.remove(crossing.body);
    const int after = medium(inside);
    if (after == before) continue;
    const Vec3 normal =
        scene::normal_at(world_.surfaces[world_.bodies[crossing.body].faces[crossing.face].surface],
                         line.origin + crossing.t * line.direction);
    const double cosine = std::min(1.0, std::abs(glm::dot(normal, line.direction)));
    visible *= 1 - shade::fresnel_reflectance(cosine, index_in(before), index_in(after));
    if (visible == core::black) return visible;
  }
  absorb(medium(inside), at);
  return visible;
}

} // namespace halftone::bench
