#pragma once
// Vectors of the engine: GLM in double precision. World space is right-handed, in scene units.

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace halftone::core {

using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

/// Linear RGB: radiance, albedo, reflectance or a coefficient, one double a channel.
using Color = glm::dvec3;

inline constexpr Color black{0, 0, 0};

inline double max_component(const Vec3& v) {
  return v.x > v.y ? (v.x > v.z ? v.x : v.z) : (v.y > v.z ? v.y : v.z);
}

} // namespace halftone::core
