// Order relations as in section 3.2 of Tadamura, Nakamae, Nishita (c. 1986), decided by a separating plane
// instead of a sample: if a face's plane has one body on its inner side and the other on its outer side, then
// the body on the eye's side of it is in front, wherever both are seen (R. Schumacker et al. 1969). Asked for
// lazily.
//
// Invariant: first and second are right for every line of sight. Where no face's plane separates two bodies
// they are said to vary, also when they are merely separated by a plane through an edge of each.

#include <halftone/order/order.h>

#include <algorithm>

namespace halftone::order {

namespace {

double height(const scene::Plane& plane, const core::Vec3& point) {
  return glm::dot(plane.normal, point) - plane.offset;
}

/// The body in front, given a plane that has the first behind it, if the second is before it.
Front by_plane(const scene::Plane& plane, const geometry::Hull& second, const core::Vec3& eye,
               double tolerance) {
  const bool separates = std::all_of(second.vertices.begin(), second.vertices.end(),
                                     [&](const core::Vec3& v) { return height(plane, v) >= -tolerance; });
  const double eye_height = height(plane, eye);
  if (!separates || eye_height == 0) return Front::varies;
  return eye_height > 0 ? Front::second : Front::first;
}

Front turned(Front front) {
  return front == Front::varies ? front : front == Front::first ? Front::second : Front::first;
}

} // namespace

bool is_seen_before(const scene::World& world, int first, int second) {
  const bool first_flat = world.bodies[first].kind == scene::BodyKind::polygon;
  const bool second_flat = world.bodies[second].kind == scene::BodyKind::polygon;
  return first_flat != second_flat ? first_flat : first > second;
}

Front Order::compare(int first, int second) {
  if (first > second) return turned(compare(second, first));
  const std::uint64_t key = static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint32_t>(second);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_[key] = find(first, second);
}

Front Order::find(int first, int second) const {
  const auto is_polygon = [&](int body) { return world_.bodies[body].kind == scene::BodyKind::polygon; };
  const auto surface = [&](int body) { return world_.bodies[body].faces[0].surface; };
  if (is_polygon(first) && is_polygon(second) && surface(first) == surface(second))
    return is_seen_before(world_, first, second) ? Front::first : Front::second;

  const double tolerance = scene::touching_distance(world_);
  const auto separated = [&](int inner, int outer) {
    for (const scene::Plane& plane : hulls_[inner].planes) {
      Front front = by_plane(plane, hulls_[outer], world_.camera.eye, tolerance);
      if (front == Front::varies && is_polygon(inner))
        front = by_plane({-plane.normal, -plane.offset}, hulls_[outer], world_.camera.eye, tolerance);
      if (front != Front::varies) return front;
    }
    return Front::varies;
  };
  const Front front = separated(first, second);
  return front != Front::varies ? front : turned(separated(second, first));
}

} // namespace halftone::order
