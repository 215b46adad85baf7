#pragma once
// Reflection and refraction at the boundary of two dielectrics. Directions have unit length; normals face the
// arriving ray: dot(direction, normal) <= 0.

#include <halftone/core/vector.h>

#include <optional>

namespace halftone::shade {

using core::Color;
using core::Vec3;

/// Mirror direction 2 (n . -d) n + d, unit length.
Vec3 reflect(const Vec3& direction, const Vec3& normal);

/// The exact unpolarised Fresnel reflectance (Born and Wolf, "Principles of Optics", 1.5.3) between the
/// medium of index n1 that the ray arrives in and n2 behind; cos_incidence in [0, 1]. 1 at total internal
/// reflection.
double fresnel_reflectance(double cos_incidence, double n1, double n2);

/// Direction behind the boundary by Snell's law, unit length; nothing at total internal reflection.
std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double n1, double n2);

/// Beer-Lambert: exp(-absorption * length) per channel; length >= 0 in scene units.
Color transmittance(const Color& absorption, double length);

} // namespace halftone::shade
