#include "convex.h"

#include "number_range.h"

#include <halftone/core/rounding.h>
#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace halftone::scene {

namespace {

using Coordinates = std::array<double, 3>;

Coordinates coordinates(const Vec3& p) { return {p.x, p.y, p.z}; }

/// A loop's vertices relative to its first, so that a small polygon far from the origin loses nothing.
std::vector<Vec3> relative(const std::vector<Vec3>& vertices, const Loop& loop) {
  std::vector<Vec3> points;
  points.reserve(loop.size());
  for (const int k : loop) points.push_back(vertices[k] - vertices[loop[0]]);
  return points;
}

const Vec3& next(const std::vector<Vec3>& points, std::size_t i) { return points[(i + 1) % points.size()]; }

/// Whether all points are within `reach` of the line from the first to the one farthest from it.
bool on_a_line(const std::vector<Vec3>& points, double reach) {
  const auto nearer = [](const Vec3& a, const Vec3& b) { return glm::dot(a, a) < glm::dot(b, b); };
  const Vec3 direction = glm::normalize(*std::max_element(points.begin(), points.end(), nearer));
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return glm::length(glm::cross(p, direction)) <= reach; });
}

/// The position of the first corner that turns against the normal by more than the reach, if there is any;
/// otherwise whole_turns says how often the loop winds.
std::optional<std::size_t> wrong_turn(const std::vector<Vec3>& points, const Vec3& normal, double reach,
                                      long& whole_turns) {
  double angle = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = (i + points.size() - 1) % points.size();
    const Vec3 from = points[i] - points[before];
    const Vec3 to = next(points, i) - points[i];
    const double turn = glm::dot(glm::cross(from, to), normal);
    const double forward = glm::dot(from, to);
    // -turn / |from + to| is the depth of the dent: the distance from the line between the neighbours.
    if (turn <= 0 && (forward < 0 || -turn > reach * glm::length(from + to))) return i;
    angle += std::atan2(turn, forward);
  }
  whole_turns = std::lround(angle / (2 * std::numbers::pi));
  return std::nullopt;
}

} // namespace

Loop without_repeats(const std::vector<Vec3>& vertices, const Loop& loop) {
  Loop kept;
  for (const int k : loop)
    if (kept.empty() || vertices[k] != vertices[kept.back()]) kept.push_back(k);
  while (kept.size() > 1 && vertices[kept.back()] == vertices[kept.front()]) kept.pop_back();
  return kept;
}

double rounding_of_heights(const std::vector<Vec3>& vertices, const Loop& loop) {
  // A coordinate is rounded when it is read (1) and when it is taken relative to the first vertex (1); a
  // cross product of two differences adds 4 to it and a dot product 4 more, of differences below 2
  // coordinates each.
  double largest = 0;
  for (const int k : loop) largest = std::max(largest, core::max_component(glm::abs(vertices[k])));
  return core::gamma(2 * 10) * largest;
}

double longest_edge(const std::vector<Vec3>& vertices, const Loop& loop) {
  double longest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    longest = std::max(longest, glm::distance(vertices[loop[i]], vertices[loop[(i + 1) % loop.size()]]));
  return longest;
}

double width(const std::vector<Vec3>& vertices, const Loop& loop) {
  // A convex area is at most its diameter times its width and at least half of that; the diameter is at most
  // twice the distance from one vertex to the farthest.
  double farthest = 0;
  for (const int k : loop) farthest = std::max(farthest, glm::distance(vertices[k], vertices[loop[0]]));
  return plane_of(vertices, loop).twice_area / (4 * farthest);
}

LoopPlane plane_of(const std::vector<Vec3>& vertices, const Loop& loop) {
  const std::vector<Vec3> points = relative(vertices, loop);
  Vec3 sum{0}, area{0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += points[i];
    area += glm::cross(points[i], next(points, i)); // the sum is Newell's
  }
  const double twice_area = glm::length(area);
  return {vertices[loop[0]], sum / static_cast<double>(points.size()), area / twice_area, twice_area};
}

std::optional<PolygonFlaw> flaw_of(const std::vector<Vec3>& vertices, const Loop& loop) {
  std::set<Coordinates> places;
  for (const int k : loop) places.insert(coordinates(vertices[k]));
  const double edge = longest_edge(vertices, loop);
  if (places.size() < 3 || edge < smallest_number)
    return PolygonFlaw{PolygonFlaw::few_vertices, loop.empty() ? 0 : loop[0]};

  const std::vector<Vec3> points = relative(vertices, loop);
  const double rounding = rounding_of_heights(vertices, loop);
  if (on_a_line(points, rounding)) return PolygonFlaw{PolygonFlaw::on_a_line, loop[0]};

  // Each corner's place may be off by the rounding, along edges of at most the longest: that much area is
  // none.
  const LoopPlane plane = plane_of(vertices, loop);
  if (plane.twice_area <= static_cast<double>(loop.size()) * edge * rounding)
    return PolygonFlaw{PolygonFlaw::not_convex, loop[0]}; // its parts cancel: it crosses itself

  for (const int k : loop)
    if (std::abs(plane.height(vertices[k])) > core::planar_slack * edge)
      return PolygonFlaw{PolygonFlaw::not_planar, k};

  long whole_turns = 0;
  if (const auto at = wrong_turn(points, plane.normal, core::planar_slack * edge, whole_turns))
    return PolygonFlaw{PolygonFlaw::not_convex, loop[*at]};
  if (whole_turns > 1) return PolygonFlaw{PolygonFlaw::winds_further, loop[0]};
  return std::nullopt;
}

std::vector<Vec3> flattened(const std::vector<Vec3>& vertices, const Loop& loop) {
  const LoopPlane plane = plane_of(vertices, loop);
  const double rounding = rounding_of_heights(vertices, loop);
  std::vector<Vec3> flat;
  flat.reserve(loop.size());
  for (const int k : loop) {
    const double height = plane.height(vertices[k]);
    flat.push_back(std::abs(height) > rounding ? vertices[k] - height * plane.normal : vertices[k]);
  }
  return flat;
}

Polyhedron welded(const Polyhedron& polyhedron) {
  std::map<Coordinates, int> first_at;
  std::vector<int> first;
  for (const Vec3& v : polyhedron.vertices)
    first.push_back(first_at.emplace(coordinates(v), static_cast<int>(first.size())).first->second);
  Polyhedron clean{polyhedron.vertices, {}};
  for (const Loop& face : polyhedron.faces) {
    Loop loop;
    for (const int k : face) loop.push_back(first[k]);
    clean.faces.push_back(without_repeats(polyhedron.vertices, loop));
  }
  return clean;
}

} // namespace halftone::scene
