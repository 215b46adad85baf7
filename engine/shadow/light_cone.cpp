// Cones around balls (J. Amanatides, "Ray tracing with cones", 1984), from the light.

#include "light_cone.h"

#include <halftone/core/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::shadow {

LightCone::LightCone(const Vec3& light, std::span<const Vec3> points, double slack) {
  Vec3 center{0};
  for (const Vec3& point : points) center += point / static_cast<double>(points.size());
  double radius = 0;
  for (const Vec3& point : points) radius = std::max(radius, glm::length(point - center));
  radius = radius * (1 + core::gamma(16)) + slack;
  const Vec3 to_center = center - light;
  const double distance = glm::length(to_center);
  all_around_ = !(radius < distance);
  if (all_around_) return;
  axis_ = to_center / distance;
  sine_ = radius / distance;
  cosine_ = std::sqrt(std::max(0.0, 1 - sine_ * sine_));
  from_ = distance - radius;
  to_ = distance + radius;
}

bool LightCone::can_shadow(const LightCone& other) const {
  if (all_around_ || other.all_around_) return true;
  // The angle between the axes against the sum of both, which is less than two right angles.
  const double cosine_of_sum = cosine_ * other.cosine_ - sine_ * other.sine_;
  return from_ <= other.to_ && glm::dot(axis_, other.axis_) >= cosine_of_sum - core::gamma(32);
}

geometry::Bounds LightCone::directions() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (all_around_) return {Vec3{-infinity}, Vec3{infinity}};
  // From the axis to the cone's circle: 2 sin(a / 2). Cosines that compare within g (can_shadow allows for
  // gamma(32), and has a few roundings of its own) are those of angles within sqrt(2 g).
  const double chord = sine_ * std::sqrt(2 / (1 + cosine_)) + std::sqrt(2 * core::gamma(64));
  return {axis_ - chord, axis_ + chord};
}

} // namespace halftone::shadow
