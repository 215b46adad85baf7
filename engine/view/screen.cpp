// Clipping by I. Sutherland and G. Hodgman, "Reentrant polygon clipping" (1974), in homogeneous coordinates
// (J. Blinn, M. Newell 1978) against the four sides of the view pyramid; hull by A. Andrew (1979), with exact
// signs.
//
// Invariant: a cut through an edge is calculated from its ends in an order that does not depend on the
// direction in which the edge is walked, so neighbours get the same bits.

#include <halftone/view/screen.h>

#include "turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace halftone::view {

namespace {

/// Signed distances to the four sides, positive inside.
std::array<double, 4> heights(const ClipPoint& p) {
  return {p.depth + p.right, p.depth - p.right, p.depth + p.up, p.depth - p.up};
}

bool before(const ClipPoint& a, const ClipPoint& b) {
  return std::tie(a.right, a.up, a.depth) < std::tie(b.right, b.up, b.depth);
}

/// The point of the edge on the side; where the edge lies in another side, so does the point. Both are made
/// exact, so that what fills the screen begins and ends with it.
ClipPoint cut(ClipPoint a, ClipPoint b, int side) {
  if (before(b, a)) std::swap(a, b);
  const std::array<double, 4> height_a = heights(a), height_b = heights(b);
  const double s = height_a[side] / (height_a[side] - height_b[side]);
  ClipPoint point{a.right + s * (b.right - a.right), a.up + s * (b.up - a.up),
                  a.depth + s * (b.depth - a.depth)};
  const auto lies_in = [&](int k) { return k == side || (height_a[k] == 0 && height_b[k] == 0); };
  if ((lies_in(0) && lies_in(1)) || (lies_in(2) && lies_in(3)))
    point.depth = 0; // opposite sides meet at the eye
  if (lies_in(0) || lies_in(1)) point.right = lies_in(0) ? -point.depth : point.depth;
  if (lies_in(2) || lies_in(3)) point.up = lies_in(2) ? -point.depth : point.depth;
  return point;
}

} // namespace

Screen::Screen(const scene::CameraFrame& camera)
    : camera_(camera),
      right_unit_(camera.right / glm::dot(camera.right, camera.right)),
      up_unit_(camera.up / glm::dot(camera.up, camera.up)) {}

ClipPoint Screen::clip_point(const Vec3& from_eye) const {
  return {glm::dot(from_eye, right_unit_), glm::dot(from_eye, up_unit_), glm::dot(from_eye, camera_.forward)};
}

bool Screen::sees(const ClipPoint& point) const {
  const std::array<double, 4> height = heights(point);
  return point.depth > 0 && std::all_of(height.begin(), height.end(), [](double h) { return h >= 0; });
}

ScreenPoint Screen::project(const ClipPoint& point) const {
  return {(point.right / point.depth + 1) * (0.5 * camera_.width),
          (1 - point.up / point.depth) * (0.5 * camera_.height)};
}

std::optional<ScreenPolygon> Screen::clipped(std::vector<ClipPoint> corners) const {
  const bool whole = std::all_of(corners.begin(), corners.end(), [&](const auto& p) { return sees(p); });
  std::vector<ClipPoint> kept;
  for (int side = 0; side < 4 && !whole; ++side) {
    kept.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ClipPoint& a = corners[i];
      const ClipPoint& b = corners[(i + 1) % corners.size()];
      const bool a_in = heights(a)[side] >= 0, b_in = heights(b)[side] >= 0;
      if (a_in) kept.push_back(a);
      if (a_in != b_in) kept.push_back(cut(a, b, side));
    }
    std::swap(corners, kept);
    if (corners.size() < 3) return std::nullopt;
  }
  ScreenPolygon polygon;
  polygon.reserve(corners.size());
  for (const ClipPoint& p : corners) {
    if (!(p.depth > 0)) continue; // the eye itself: of a region that has it on its edge, the rest remains
    polygon.push_back(project(p));
  }
  if (polygon.size() < 3) return std::nullopt;
  return polygon;
}

std::optional<Linear> Screen::inverse_depth(const scene::Plane& plane) const {
  const double height = plane.offset - glm::dot(plane.normal, camera_.eye);
  if (height == 0) return std::nullopt;
  // 1/depth = normal . direction(x, y) / height, and the direction is linear in x and y.
  const double across = glm::dot(plane.normal, camera_.right) / height;
  const double along = glm::dot(plane.normal, camera_.up) / height;
  const double ahead = glm::dot(plane.normal, camera_.forward) / height;
  return Linear{2 * across / camera_.width, -2 * along / camera_.height, ahead - across + along};
}

Vec3 Screen::direction(double x, double y) const {
  return camera_.forward + camera_.right * (2 * x / camera_.width - 1) +
         camera_.up * (1 - 2 * y / camera_.height);
}

ScreenPolygon Screen::whole() const {
  const double width = camera_.width, height = camera_.height;
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

double signed_area(const ScreenPolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += turn(polygon[0], polygon[i], polygon[i + 1]);
  return twice / 2;
}

std::optional<Extent> extent_at(const ScreenPolygon& polygon, double y) {
  std::optional<Extent> extent;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ScreenPoint* a = &polygon[i];
    const ScreenPoint* b = &polygon[(i + 1) % polygon.size()];
    if (a->y > b->y) std::swap(a, b);
    if (!(a->y <= y && y < b->y)) continue; // half open: a corner belongs to one edge, a level edge to none
    const double x = a->x + (b->x - a->x) * ((y - a->y) / (b->y - a->y));
    if (!extent) extent = Extent{x, x};
    extent->left = std::min(extent->left, x);
    extent->right = std::max(extent->right, x);
  }
  return extent;
}

int chords_of(double pixels_across, double sagitta) {
  // An ellipse's longer half axis a, in n chords: the sagitta is at most a (1 - cos(pi / n)) < a pi^2 / (2
  // n^2). Perspective spaces the points unevenly: half as many again.
  const double chords = 1.5 * std::numbers::pi * std::sqrt(pixels_across / 2 / (2 * sagitta));
  return 8 * static_cast<int>(std::clamp(chords, 16.0, 1.0 * most_chords) / 8);
}

double excess(const ScreenPolygon& polygon, const ScreenPolygon& over) {
  const auto corner = [](const ScreenPolygon& of, std::size_t k) { return of[k % of.size()]; };
  // A hull goes from its leftmost corner to its rightmost one, and back: no angle on the way, and no edge
  // that is too short for its direction to be known, hides which edge a corner lies at.
  const auto rightmost = [](const ScreenPolygon& of) {
    return static_cast<std::size_t>(std::max_element(of.begin(), of.end(),
                                                     [](const auto& p, const auto& q) {
                                                       return std::tie(p.x, p.y) < std::tie(q.x, q.y);
                                                     }) -
                                    of.begin());
  };
  double most = 0;
  const auto compare = [&](std::size_t from, std::size_t to, std::size_t edge, std::size_t edges_end,
                           double way) {
    for (std::size_t k = from; k <= to; ++k) {
      const ScreenPoint c = corner(polygon, k);
      while (edge + 1 < edges_end && way * corner(over, edge + 1).x < way * c.x) ++edge;
      const ScreenPoint a = corner(over, edge), b = corner(over, edge + 1);
      most = std::max(most, -turn(a, b, c) / std::hypot(b.x - a.x, b.y - a.y));
    }
  };
  const std::size_t right = rightmost(polygon), over_right = rightmost(over);
  compare(0, right, 0, over_right, 1);
  compare(right, polygon.size(), over_right, over.size(), -1);
  return most;
}

bool are_apart(const ScreenPolygon& a, const ScreenPolygon& b) {
  const auto separates = [](const ScreenPolygon& polygon, const ScreenPolygon& other) {
    const double sign = signed_area(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ScreenPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      if (std::all_of(other.begin(), other.end(), [&](const auto& r) { return turn(p, q, r) * sign < 0; }))
        return true;
    }
    return false;
  };
  return separates(a, b) || separates(b, a);
}

std::optional<ScreenPolygon> convex_hull(std::vector<ScreenPoint> points) {
  std::sort(points.begin(), points.end(), [](const ScreenPoint& a, const ScreenPoint& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  });
  ScreenPolygon hull;
  const auto half = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= start + 2 && exact_turn(hull[hull.size() - 2], hull.back(), *p) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    if (!hull.empty()) hull.pop_back();
  };
  half(points.begin(), points.end());
  half(points.rbegin(), points.rend());
  if (hull.size() < 3) return std::nullopt;
  return hull;
}

} // namespace halftone::view
