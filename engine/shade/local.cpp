// B. T. Phong, "Illumination for computer generated pictures" (1975), with the reflected light's direction.

#include <halftone/shade/local.h>

#include <halftone/core/elementary.h>

#include <algorithm>

namespace halftone::shade {

Color direct_light(const SurfacePoint& point, const scene::Light& light) {
  const Vec3 l = to_light(point, light);
  // Rounding may take cosines out of [0, 1]: a light of 1e60 makes much of a little below 0, a shininess of
  // 1e60 of a little above 1.
  const double n_l = std::clamp(glm::dot(point.normal, l), 0.0, 1.0);
  Color sum = point.albedo * n_l;
  const double r_v = std::min(-glm::dot(point.normal * (2 * n_l) - l, point.direction), 1.0);
  // r^s <= exp(s (r - 1)): below 2^-60 it does not matter, and no power is calculated.
  if (r_v > 0 && point.shininess * (1 - r_v) < 42 && point.specular != core::black)
    sum += point.specular * core::pow(r_v, point.shininess);
  return light.color * sum;
}

} // namespace halftone::shade
