// Tadamura, Nakamae, Nishita (c. 1986), section 3.4.3 and figure 7: the two ends of the hull's shadow
// interval go back to world space, and the segment between them is cut with the cone from the light around
// the sphere. With u from the light to a point of the segment and c to the centre, the point is in the cone
// where (u . c)^2 - |u|^2 (|c|^2 - r^2) >= 0 and u . c > 0: one quadratic along the segment.
//
// Invariant: the cone lies within the hull's volume, so its interval lies within the given one.

#include "sphere_shadow.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

using core::Vec3;

/// The part of [0, 1] where a s^2 + 2 b s + c >= 0, given that it is one interval in which the segment passes
/// the cone.
std::optional<std::pair<double, double>> inside_cone(double a, double b, double c) {
  if (a == 0) {
    if (b == 0) return c >= 0 ? std::optional(std::pair(0.0, 1.0)) : std::nullopt;
    const double s = -c / (2 * b);
    return b > 0 ? std::pair(std::max(s, 0.0), 1.0) : std::pair(0.0, std::min(s, 1.0));
  }
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return a > 0 ? std::optional(std::pair(0.0, 1.0)) : std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const auto [low, high] = std::minmax({q / a, c / q});
  if (a < 0) return std::pair(std::max(low, 0.0), std::min(high, 1.0));
  // Inside lies beyond one of the roots: the segment runs into the cone or out of it (the other is the far
  // nappe's).
  if (c >= 0) return std::pair(0.0, low > 0 ? std::min(low, 1.0) : 1.0);
  return std::pair(std::max(high, 0.0), 1.0);
}

} // namespace

std::optional<SphereShadow> exact_sphere_shadow(const Frame& frame, const ScreenFace& face, int caster,
                                                int light, double y, const view::Extent& extent) {
  const scene::Body& body = frame.world.bodies[caster];
  if (body.kind != scene::BodyKind::sphere) return std::nullopt;
  const auto& sphere = std::get<scene::SphereSurface>(frame.world.surfaces[body.faces[0].surface]);
  const Vec3& light_position = frame.world.lights[light].position;
  const scene::Face& receiver = frame.world.bodies[face.body].faces[face.face];
  const auto& plane = std::get<scene::Plane>(frame.world.surfaces[receiver.surface]);
  const double light_height = glm::dot(plane.normal, light_position) - plane.offset;
  const double center_height =
      (glm::dot(plane.normal, sphere.center) - plane.offset) * (light_height > 0 ? 1 : -1);
  const double tolerance =
      frame.world.extent * 0x1p-36; // what is nearer touches (the scene format, section 3)
  // The discriminant below is of degree 8 in length. A power of two changes no bit and keeps it within range.
  const double unit = std::scalbn(1.0, -std::ilogb(frame.world.extent));
  const Vec3 c = (sphere.center - light_position) * unit;
  const double radius = sphere.radius * unit;
  const double tangent_squared = glm::dot(c, c) - radius * radius;
  if (center_height < sphere.radius - tolerance || tangent_squared <= 0) return std::nullopt;

  const auto point_at = [&](double x) {
    return frame.world.camera.eye + frame.screen.direction(x, y) / face.inverse_depth.at(x, y);
  };
  const Vec3 start = point_at(extent.left), step = point_at(extent.right) - start;
  const Vec3 u = (start - light_position) * unit, v = step * unit;
  const auto product = [&](const Vec3& p, const Vec3& q) {
    return glm::dot(p, c) * glm::dot(q, c) - glm::dot(p, q) * tangent_squared;
  };
  SphereShadow shadow{std::nullopt, !frame.world.materials[body.material].glass};
  const auto part = inside_cone(product(v, v), product(u, v), product(u, u));
  if (!part || !(part->first < part->second)) return shadow;
  const double middle = (part->first + part->second) / 2;
  if (glm::dot(u + v * middle, c) <= 0) return shadow; // the nappe behind the light
  const auto x_at = [&](double s) {
    const view::ClipPoint p = frame.screen.clip_point(start + step * s - frame.world.camera.eye);
    return (p.right / p.depth + 1) * (0.5 * frame.screen.camera().width);
  };
  shadow.extent = view::Extent{part->first > 0 ? x_at(part->first) : extent.left,
                               part->second < 1 ? x_at(part->second) : extent.right};
  if (shadow.extent->left > shadow.extent->right) std::swap(shadow.extent->left, shadow.extent->right);
  return shadow;
}

} // namespace halftone::scan
