#include <halftone/shade/fresnel.h>

#include <halftone/core/elementary.h>

#include <algorithm>
#include <cmath>

namespace halftone::shade {

namespace {

/// Cosine of the refracted ray squared; not positive at total internal reflection and at the critical angle.
double cos_squared_behind(double cos_incidence, double n1, double n2) {
  const double eta = n1 / n2;
  return 1 - eta * eta * (1 - cos_incidence * cos_incidence);
}

} // namespace

Vec3 reflect(const Vec3& direction, const Vec3& normal) {
  return glm::normalize(direction - normal * (2 * glm::dot(direction, normal)));
}

double fresnel_reflectance(double cos_incidence, double n1, double n2) {
  const double cos_squared = cos_squared_behind(cos_incidence, n1, n2);
  if (cos_squared <= 0) return 1;
  const double cos_behind = std::sqrt(cos_squared);
  const double s = (n1 * cos_incidence - n2 * cos_behind) / (n1 * cos_incidence + n2 * cos_behind);
  const double p = (n2 * cos_incidence - n1 * cos_behind) / (n2 * cos_incidence + n1 * cos_behind);
  return std::min(1.0, (s * s + p * p) / 2);
}

// From the component along the boundary, which alone grows with n1 / n2: were the one along the normal scaled
// too, only to be taken away again, it would drown the direction where n1 / n2 is large.
std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double n1, double n2) {
  const Vec3 along = (direction - normal * glm::dot(direction, normal)) * (n1 / n2);
  const double cos_squared = 1 - glm::dot(along, along);
  if (cos_squared <= 0) return std::nullopt;
  return glm::normalize(along - normal * std::sqrt(cos_squared));
}

Color transmittance(const Color& absorption, double length) {
  if (absorption == core::black) return Color{1};
  return {core::exp(-absorption.r * length), core::exp(-absorption.g * length),
          core::exp(-absorption.b * length)};
}

} // namespace halftone::shade
