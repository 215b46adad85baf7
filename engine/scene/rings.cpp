#include "rings.h"

#include <halftone/core/elementary.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halftone::scene {

std::pair<double, double> sin_cos_degrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0); // exact
  if (turn == 0) return {0, 1};
  if (turn == 90) return {1, 0};
  if (turn == -90) return {-1, 0};
  if (std::abs(turn) == 180) return {0, -1};
  const auto [sin, cos] = core::sin_cos(turn * (std::numbers::pi / 180));
  return {sin, cos};
}

namespace {

std::vector<int> reversed(std::vector<int> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

} // namespace

Faceted faceted_frustum(const Frustum& frustum, int sides, double turn_degrees) {
  const Vec3 axis = glm::normalize(frustum.top - frustum.base);
  const Vec3 hint = std::abs(axis.x) > 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 u = glm::normalize(hint - axis * glm::dot(hint, axis));
  const Vec3 v = glm::cross(axis, u);

  Faceted result;
  const auto ring = [&](const Vec3& center, double radius) {
    std::vector<int> loop;
    for (int k = 0; k < (radius > 0 ? sides : 1); ++k) {
      const auto [sin, cos] = sin_cos_degrees(turn_degrees + 360.0 * k / sides);
      loop.push_back(static_cast<int>(result.vertices.size()));
      result.vertices.push_back(center + radius * (u * cos + v * sin));
    }
    return loop;
  };
  const std::vector<int> lower = ring(frustum.base, frustum.base_radius);
  const std::vector<int> upper = ring(frustum.top, frustum.top_radius);

  const auto at = [](const std::vector<int>& loop, int k) { return loop[k % loop.size()]; };
  for (int k = 0; k < sides; ++k) {
    std::vector<int> side{at(lower, k), at(lower, k + 1), at(upper, k + 1), at(upper, k)};
    side.erase(std::unique(side.begin(), side.end()), side.end());
    if (side.front() == side.back()) side.pop_back();
    result.faces.push_back(side);
  }
  if (lower.size() > 1) result.faces.push_back(reversed(lower));
  if (upper.size() > 1) result.faces.push_back(upper);
  result.caps = static_cast<int>(result.faces.size()) - sides;
  return result;
}

Faceted faceted_sphere(const Sphere& sphere, int meridians) {
  const int bands = std::max(2, meridians / 2);
  Faceted result;
  const auto vertex = [&](int band, int meridian) {
    return 2 + (band - 1) * meridians + meridian % meridians;
  };
  result.vertices = {sphere.center - Vec3{0, 0, sphere.radius}, sphere.center + Vec3{0, 0, sphere.radius}};
  for (int band = 1; band < bands; ++band) {
    const auto [sin_latitude, cos_latitude] = sin_cos_degrees(-90 + 180.0 * band / bands);
    for (int k = 0; k < meridians; ++k) {
      const auto [sin, cos] = sin_cos_degrees(360.0 * k / meridians);
      result.vertices.push_back(sphere.center +
                                sphere.radius * Vec3{cos_latitude * cos, cos_latitude * sin, sin_latitude});
    }
  }
  for (int k = 0; k < meridians; ++k) {
    result.faces.push_back({0, vertex(1, k + 1), vertex(1, k)});
    for (int band = 1; band + 1 < bands; ++band)
      result.faces.push_back(
          {vertex(band, k), vertex(band, k + 1), vertex(band + 1, k + 1), vertex(band + 1, k)});
    result.faces.push_back({vertex(bands - 1, k), vertex(bands - 1, k + 1), 1});
  }
  return result;
}

Faceted box_faces(const Box& box) {
  Faceted result;
  for (int k = 0; k < 8; ++k)
    result.vertices.push_back(
        {k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z});
  result.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return result;
}

} // namespace halftone::scene
