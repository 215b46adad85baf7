// B. T. Phong, "Illumination for computer generated pictures" (1975), with the reflected light's direction.

#include <halftone/shade/local.h>

#include <halftone/core/elementary.h>

namespace halftone::shade {

Vec3 to_light(const SurfacePoint& point, const scene::Light& light) {
  return glm::normalize(light.position - point.position);
}

bool faces(const SurfacePoint& point, const scene::Light& light) {
  return glm::dot(point.normal, light.position - point.position) > 0;
}

Color direct_light(const SurfacePoint& point, const scene::Light& light) {
  const Vec3 l = to_light(point, light);
  const double n_l = glm::dot(point.normal, l);
  Color sum = point.albedo * n_l;
  const double r_v = -glm::dot(point.normal * (2 * n_l) - l, point.direction);
  if (r_v > 0 && point.specular != core::black) sum += point.specular * core::pow(r_v, point.shininess);
  return light.color * sum;
}

} // namespace halftone::shade
