// Cones of light around bounding balls (J. Amanatides, "Ray tracing with cones", 1984), one dot product a
// body; for many segments at once, boxes around the directions in them (our own, after E. Haines and
// D. Greenberg, "The light buffer", 1986). A body that nothing lies behind is no caster: a polygon for which
// the whole world is on the light's side, as floors and walls mostly are.
//
// Invariant: complete. No body that stands between the light and a point of any body is left out.

#include "casters.h"

#include <halftone/core/memory.h>
#include <halftone/core/rounding.h>
#include <halftone/geometry/balls.h>
#include <halftone/geometry/position.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halftone::trace {

namespace {

using core::Vec3;

/// Corners of a box around all bodies.
std::array<Vec3, 8> corners_of(const scene::World& world) {
  Vec3 low{world.extent}, high{-world.extent};
  for (const scene::Body& body : world.bodies) {
    low = glm::min(low, body.bounds[0]);
    high = glm::max(high, body.bounds[1]);
  }
  std::array<Vec3, 8> corners;
  for (int k = 0; k < 8; ++k)
    corners[k] = {k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z};
  return corners;
}

/// Whether a light cannot be blocked by a polygon: it lies in its plane, or everything is on its side of the
/// plane.
bool is_harmless(const scene::World& world, const scene::Surface& plane, const Vec3& light,
                 const std::array<Vec3, 8>& corners) {
  const geometry::Height own = geometry::height_over(world, plane, light);
  if (own.is_on()) return true;
  return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
    const geometry::Height height = geometry::height_over(world, plane, corner);
    return (own.value > 0 ? height.value : -height.value) >= -height.bound;
  });
}

} // namespace

Casters::Casters(const scene::World& world, const Vec3& light) : is_caster_(world.bodies.size()) {
  const std::array<Vec3, 8> corners = corners_of(world);
  const auto is_opaque = [&](int body) { return !world.materials[world.bodies[body].material].glass; };
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const scene::Body& body = world.bodies[b];
    if (body.kind == scene::BodyKind::polygon &&
        is_harmless(world, world.surfaces[body.faces[0].surface], light, corners))
      continue;
    bodies_.push_back(b);
    is_caster_[b] = true;
  }
  const auto glass = std::stable_partition(bodies_.begin(), bodies_.end(), is_opaque);
  opaque_ = static_cast<std::size_t>(glass - bodies_.begin());

  std::vector<geometry::Bounds> boxes;
  for (const int b : bodies_) {
    const geometry::Ball ball = geometry::bounding_ball(world, world.bodies[b]);
    // Shadow rays start on bodies, within 2 extents of the origin, and pass the light up to rounding.
    const double reach = ball.radius + ball.growth * (glm::length(ball.center) + 2 * world.extent) +
                         core::gamma(64) * (glm::length(light) + 2 * world.extent);
    const Vec3 to_center = ball.center - light;
    const double distance = glm::length(to_center);
    const bool is_apart = reach < distance * (1 - core::gamma(16));
    const Vec3 axis = is_apart ? to_center / distance : Vec3{0};
    const double sine = reach / distance;
    x_.push_back(axis.x);
    y_.push_back(axis.y);
    z_.push_back(axis.z);
    cosine_.push_back(is_apart ? std::sqrt(std::max(0.0, 1 - sine * sine - core::gamma(32))) - core::gamma(32)
                               : -1.0);
    from_.push_back(is_apart ? distance - reach - core::gamma(16) * distance : 0.0);
    // |d - a|^2 = 2 - 2 d.a for unit vectors, to some roundings.
    const double spread = std::sqrt(2 - 2 * cosine_.back() + core::gamma(32));
    boxes.push_back({axis - spread, axis + spread});
  }
  directions_ = geometry::BoundsTree(boxes);
}

std::size_t Casters::memory() const {
  std::size_t bytes = core::memory_of(is_caster_) + core::memory_of(bodies_) + directions_.memory();
  for (const auto* numbers : {&x_, &y_, &z_, &cosine_, &from_}) bytes += core::memory_of(*numbers);
  return bytes;
}

Casters::Found Casters::gather(const Vec3& direction, double distance, std::vector<int>& memory) const {
  if (memory.size() < bodies_.size()) memory.resize(bodies_.size());
  std::size_t count = 0, opaque = 0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (k == opaque_) opaque = count;
    const double cosine = x_[k] * direction.x + y_[k] * direction.y + z_[k] * direction.z;
    memory[count] = bodies_[k];
    count += cosine >= cosine_[k] && distance >= from_[k] ? 1 : 0;
  }
  if (opaque_ == bodies_.size()) opaque = count;
  return {memory.data(), memory.data() + opaque, memory.data() + count};
}

void Casters::gather(const geometry::Bounds& directions, Lists& lists) const {
  lists.opaque.clear();
  lists.glass.clear();
  directions_.meeting(
      directions, [&](std::size_t k) { (k < opaque_ ? lists.opaque : lists.glass).push_back(bodies_[k]); });
}

} // namespace halftone::trace
