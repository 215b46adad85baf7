// Tadamura, Nakamae, Nishita (c. 1986), section 3.4.3 and figure 7: the two ends of the hull's shadow
// interval go back to world space, and the segment between them is cut with the cone from the light around
// the sphere. With u from the light to a point of the segment and c to the centre, the point is in the cone
// where r^2 |u|^2 - |u x c|^2 >= 0 and u . c > 0: one quadratic along the segment, whose roots may belong to
// either nappe of the double cone. u x c is taken as w x c, w being the way from the centre to the point: the
// paper's (u . c)^2 - |u|^2 (|c|^2 - r^2) is the same, but what is left of it is r^2 / |c|^2 of its terms, so
// that a light that is far off moved the ends by |c| / r roundings.
//
// Invariant: the cone lies within the hull's volume, so its interval lies within the given one.

#include "sphere_shadow.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

using core::Vec3;

/// A quadratic a s^2 + 2 b s + c that is not negative in a double cone, along a segment on which s goes from
/// 0 to 1.
struct Quadratic {
  double a = 0, b = 0, c = 0;
};

/// The part of the segment that is in the nappe before the light. forward(s): the sign of u . c there;
/// towards: that of its growth with s. The nappe is convex, so the part is one interval: between the roots,
/// or, where the segment's line goes from one nappe into the other (a >= 0), beyond the root on the side of
/// this one.
template<typename Forward>
std::optional<std::pair<double, double>> inside_nappe(const Quadratic& f, Forward forward, double towards) {
  double low = 0, high = 1;
  if (f.a == 0) { // along a generator: beyond one point
    const double root = -f.c / (2 * f.b);
    if (f.b > 0) low = std::max(low, root);
    if (f.b < 0) high = std::min(high, root);
    if (f.b == 0 && f.c < 0) return std::nullopt;
  } else {
    const double discriminant = f.b * f.b - f.a * f.c;
    if (f.a < 0 && discriminant <= 0) return std::nullopt;
    const double q = -(f.b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), f.b));
    const auto [first, second] = std::minmax({q / f.a, q == 0 ? 0.0 : f.c / q});
    if (f.a < 0 || towards > 0) low = std::max(low, f.a < 0 ? first : second);
    if (f.a < 0 || towards < 0) high = std::min(high, f.a < 0 ? second : first);
  }
  if (!(low < high) || forward((low + high) / 2) <= 0) return std::nullopt;
  return std::pair(low, high);
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
  const double tolerance = scene::touching_distance(frame.world);
  // The discriminant below is of degree 8 in length. A power of two changes no bit and keeps it within range.
  const double unit = std::scalbn(1.0, -std::ilogb(frame.world.extent));
  const Vec3 c = (sphere.center - light_position) * unit;
  const double radius = sphere.radius * unit;
  if (center_height < sphere.radius - tolerance || glm::dot(c, c) <= radius * radius) return std::nullopt;

  const auto point_at = [&](double x) {
    return frame.world.camera.eye + frame.screen.direction(x, y) / face.inverse_depth.at(x, y);
  };
  const Vec3 start = point_at(extent.left), step = point_at(extent.right) - start;
  const Vec3 u = (start - light_position) * unit, v = step * unit;
  const Vec3 u_across = glm::cross((start - sphere.center) * unit, c), v_across = glm::cross(v, c);
  const double rr = radius * radius;
  SphereShadow shadow{std::nullopt, !frame.world.materials[body.material].glass};
  const auto part = inside_nappe(
      {rr * glm::dot(v, v) - glm::dot(v_across, v_across), rr * glm::dot(u, v) - glm::dot(u_across, v_across),
       rr * glm::dot(u, u) - glm::dot(u_across, u_across)},
      [&](double at) { return glm::dot(u + v * at, c); }, glm::dot(v, c));
  if (!part) return shadow;
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
