#pragma once
// Reflection and refraction at the boundary of two dielectrics. Directions have unit length; normals face the
// arriving ray: dot(direction, normal) <= 0.

#include <halftone/core/vector.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halftone::shade {

using core::Color;
using core::Vec3;

/// Mirror direction 2 (n . -d) n + d, unit length.
inline Vec3 reflect(const Vec3& direction, const Vec3& normal) {
  return glm::normalize(direction - normal * (2 * glm::dot(direction, normal)));
}

/// The exact unpolarised Fresnel reflectance (Born and Wolf, "Principles of Optics", 1.5.3) between the
/// medium of index n1 that the ray arrives in and n2 behind; cos_incidence in [0, 1]. 1 at total internal
/// reflection.
inline double fresnel_reflectance(double cos_incidence, double n1, double n2) {
  const double eta = n1 / n2;
  const double cos_squared = 1 - eta * eta * (1 - cos_incidence * cos_incidence);
  if (cos_squared <= 0) return 1; // at the critical angle too
  const double cos_behind = std::sqrt(cos_squared);
  const double s = (n1 * cos_incidence - n2 * cos_behind) / (n1 * cos_incidence + n2 * cos_behind);
  const double p = (n2 * cos_incidence - n1 * cos_behind) / (n2 * cos_incidence + n1 * cos_behind);
  return std::min(1.0, (s * s + p * p) / 2);
}

/// Direction behind the boundary by Snell's law, unit length; nothing at total internal reflection.
// From the component along the boundary, which alone grows with n1 / n2: were the one along the normal scaled
// too, only to be taken away again, it would drown the direction where n1 / n2 is large.
inline std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double n1, double n2) {
  const Vec3 along = (direction - normal * glm::dot(direction, normal)) * (n1 / n2);
  const double cos_squared = 1 - glm::dot(along, along);
  if (cos_squared <= 0) return std::nullopt;
  return glm::normalize(along - normal * std::sqrt(cos_squared));
}

/// Beer-Lambert: exp(-absorption * length) per channel; length >= 0 in scene units.
Color transmittance(const Color& absorption, double length);

} // namespace halftone::shade
