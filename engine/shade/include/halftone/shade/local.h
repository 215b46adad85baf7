#pragma once
// Local illumination: the terms of the scene format's section 3 that need no further ray but the light's.

#include <halftone/scene/scene.h>

namespace halftone::shade {

using core::Color;
using core::Vec3;

/// A point as a ray along `direction` sees it. direction and normal have unit length; the normal faces the
/// ray.
struct SurfacePoint {
  Vec3 position{0};
  Vec3 direction{0};
  Vec3 normal{0};
  Color albedo{0};
  Color specular{0};
  double shininess = 0;
};

/// Unit vector from the point to the light.
inline Vec3 to_light(const SurfacePoint& point, const scene::Light& light) {
  return glm::normalize(light.position - point.position);
}

/// Whether the light is in front of the surface: n . l > 0. Behind it, it contributes nothing.
inline bool faces(const SurfacePoint& point, const scene::Light& light) {
  return glm::dot(point.normal, light.position - point.position) > 0;
}

/// The light's diffuse and specular terms at full visibility, for a light that the surface faces; to be
/// multiplied per channel by the light's visibility V.
Color direct_light(const SurfacePoint& point, const scene::Light& light);

} // namespace halftone::shade
