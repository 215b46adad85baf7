// Bounding balls that stay right in floating point. Our own bound: let c be a point inside a convex body
// whose faces all lie at least rho from c, within `off` of the surfaces that the body is cut with (shared
// surfaces are only near to a face), and let rounding let a line pass each of these by e. From c, the line
// can then be no farther outside than by the factor (h + e) / (h - off), h >= rho, which is below 1 + 2 (e +
// off) / rho where off <= rho / 2. In a ball of radius r around the body that is 4 (e + off) r / rho at most.
// The body, grown from c by this factor, is as much larger on each side: its box along the axes as well.
//
// Invariant: no line that Solids finds to meet a body is turned away.

#include <halftone/geometry/balls.h>

#include <halftone/core/memory.h>
#include <halftone/core/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::geometry {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A ball around a body as its faces say, and how far rounding and shared surfaces can change that.
struct Hold {
  Vec3 center{0};
  double radius = 0;
  double depth = 0; ///< rho
  double off = 0;
};

Hold hold_of(const scene::SphereSurface& sphere) { return {sphere.center, sphere.radius, sphere.radius, 0}; }

/// Of a polygon the depth counts in its plane.
Hold hold_of_flat(const scene::World& world, const scene::Body& body) {
  Hold hold;
  Vec3 mean{0};
  double corners = 0;
  for (const scene::Face& face : body.faces) {
    const auto& plane = std::get<scene::Plane>(world.surfaces[face.surface]);
    for (const Vec3& corner : face.outline) {
      mean += corner;
      ++corners;
      hold.off = std::max(hold.off, std::abs(glm::dot(plane.normal, corner) - plane.offset));
    }
  }
  mean /= corners;
  hold.center = (body.bounds[0] + body.bounds[1]) / 2.0;
  hold.depth = infinity;
  for (const scene::Face& face : body.faces) {
    const auto& plane = std::get<scene::Plane>(world.surfaces[face.surface]);
    const Vec3 outward = face.flipped ? -plane.normal : plane.normal;
    for (std::size_t k = 0; k < face.outline.size(); ++k) {
      const Vec3& corner = face.outline[k];
      hold.radius = std::max(hold.radius, glm::length(corner - hold.center));
      if (body.kind != scene::BodyKind::polygon) continue;
      const Vec3 along = face.outline[(k + 1) % face.outline.size()] - corner;
      hold.depth = std::min(hold.depth, glm::dot(glm::normalize(glm::cross(along, outward)), corner - mean));
    }
    if (body.kind != scene::BodyKind::polygon)
      hold.depth = std::min(hold.depth, glm::dot(outward, face.outline[0] - mean));
  }
  return hold;
}

/// Between the two ends on the axis of the side: where a disc cuts it, or the apex.
Hold hold_of_frustum(const scene::World& world, const scene::Body& body) {
  const auto& side = std::get<scene::ConeSurface>(world.surfaces[body.faces[0].surface]);
  double heights[2] = {-side.radius / side.slope, 0};
  Hold hold;
  for (std::size_t f = 1; f < body.faces.size(); ++f) {
    const auto& disc = std::get<scene::Plane>(world.surfaces[body.faces[f].surface]);
    const double along = glm::dot(disc.normal, side.axis);
    heights[2 - f] = (disc.offset - glm::dot(disc.normal, side.origin)) / along;
    const double radius = side.radius + side.slope * heights[2 - f];
    hold.off = std::max(hold.off, radius * glm::length(disc.normal - side.axis * along));
  }
  const double length = std::abs(heights[1] - heights[0]);
  const auto radius_at = [&](double height) { return std::max(0.0, side.radius + side.slope * height); };
  const double r0 = radius_at(heights[0]), r1 = radius_at(heights[1]);
  // As far from one end's rim as from the other's, but not outside.
  const double share = std::clamp(0.5 + (r1 * r1 - r0 * r0) / (2 * length * length), 0.0, 1.0);
  hold.center = side.origin + side.axis * (heights[0] + (heights[1] - heights[0]) * share);
  hold.radius = std::max(std::hypot(share * length, r0), std::hypot((1 - share) * length, r1));
  hold.depth = std::min(length / 2, radius_at((heights[0] + heights[1]) / 2) / std::hypot(1, side.slope));
  return hold;
}

Hold hold_of(const scene::World& world, const scene::Body& body) {
  if (body.kind == scene::BodyKind::sphere)
    return hold_of(std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]));
  return body.kind == scene::BodyKind::frustum ? hold_of_frustum(world, body) : hold_of_flat(world, body);
}

} // namespace

namespace {

/// How far outside of a body, as its faces say, a line may meet it: fixed + growth * d.
struct Blur {
  double fixed = 0;
  double growth = 0;
};

Blur blur_of(const Hold& hold) {
  if (!(hold.depth > 2 * hold.off)) return {0, infinity};
  const double flatness = 4 * hold.radius / hold.depth;
  // Distances from surfaces have an error below 32 roundings of the coordinates and distances that enter.
  const double fixed = hold.off + core::gamma(64) * (glm::length(hold.center) + hold.radius);
  return {flatness * fixed, flatness * core::gamma(32)};
}

} // namespace

Ball bounding_ball(const scene::World& world, const scene::Body& body) {
  const Hold hold = hold_of(world, body);
  const Blur blur = blur_of(hold);
  return {hold.center, hold.radius + blur.fixed, blur.growth};
}

Bounds bounding_box(const scene::World& world, const scene::Body& body, double reach) {
  const Hold hold = hold_of(world, body);
  const Blur blur = blur_of(hold);
  // A point of the line at a distance that was found has the rounding of coordinates and distances in it.
  const double farthest = reach + glm::length(hold.center) + hold.radius;
  const double margin = blur.fixed + (blur.growth + core::gamma(64)) * farthest;
  return {body.bounds[0] - margin, body.bounds[1] + margin};
}

Balls::Balls(const scene::World& world) {
  for (const scene::Body& body : world.bodies) {
    const Ball ball = bounding_ball(world, body);
    x_.push_back(ball.center.x);
    y_.push_back(ball.center.y);
    z_.push_back(ball.center.z);
    // (radius + growth d)^2 <= radius^2 (1 + g) + growth^2 d^2 (1 + 1 / g) for any g > 0.
    const double g = core::gamma(64);
    reach_squared_.push_back(ball.radius * ball.radius * (1 + g));
    kept_.push_back(1 - core::gamma(32) - ball.growth * ball.growth * (1 + 1 / g));
    // The line's origin is within 2 (|b| + radius) of the center where the line passes the ball and growth <
    // 1/4.
    const double blur = 2 * ball.growth + core::gamma(16);
    const bool is_sharp = ball.growth < 0.25;
    nearer_.push_back(is_sharp ? 1 - blur : 0);
    before_.push_back(is_sharp ? ball.radius * (1 + blur) : infinity);
  }
}

std::size_t Balls::memory() const {
  std::size_t bytes = 0;
  for (const auto* numbers : {&x_, &y_, &z_, &reach_squared_, &kept_, &nearer_, &before_})
    bytes += core::memory_of(*numbers);
  return bytes;
}

std::span<const Near> Balls::gather(const Line& line, std::vector<Near>& memory) const {
  const std::size_t bodies = x_.size();
  if (memory.size() < bodies) memory.resize(bodies);
  std::size_t count = 0;
  for (std::size_t b = 0; b < bodies; ++b) {
    const Vec3 to_center = center_from(b, line);
    const double along = glm::dot(to_center, line.direction);
    memory[count] = {static_cast<int>(b), along * nearer_[b] - before_[b]};
    count += is_missed(b, glm::dot(to_center, to_center), along) ? 0 : 1;
  }
  return {memory.data(), count};
}

} // namespace halftone::geometry
