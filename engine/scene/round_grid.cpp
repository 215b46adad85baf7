// A hash grid of spheres' centers and radii, and one of cones' axes: by their direction and, within bundles
// of the same direction up to the touching share, by their points nearest to the origin.
//
// Let an axis a pass within the tolerance of a point c, and another, a0, pass through it, |a - a0| <= e. Then
// the points nearest to the origin, c - a (a . c) and c - a0 (a0 . c), are within tolerance + 2 e |c|.

#include "round_grid.h"

#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <cmath>

namespace halftone::scene {

namespace {

using core::plane_cell; // of directions

std::array<double, 4> point_of(const SphereSurface& sphere) {
  return {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius};
}

std::array<double, 3> nearest_to_origin(const Vec3& axis, const Vec3& through) {
  const Vec3 nearest = through - axis * glm::dot(axis, through);
  return {nearest.x, nearest.y, nearest.z};
}

std::array<int, 3> cell_of(const Vec3& direction, double moved) {
  std::array<int, 3> cell;
  for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::floor((direction[k] + moved) / plane_cell));
  return cell;
}

} // namespace

RoundGrid::RoundGrid(double reach, double tolerance)
    : reach_(reach),
      tolerance_(tolerance),
      spheres_(reach, 2 * tolerance) {}

void RoundGrid::insert(const Surface& round, int number) {
  if (const auto* sphere = std::get_if<SphereSurface>(&round)) {
    spheres_.insert(point_of(*sphere), number);
    return;
  }
  const auto& cone = std::get<ConeSurface>(round);
  const FineCell fine = fine_cell(cone.axis);
  std::vector<Bundle>& bundles = cones_[cell_of(cone.axis, 0)];
  auto bundle = std::find_if(bundles.begin(), bundles.end(), [&](const Bundle& b) { return b.fine == fine; });
  if (bundle == bundles.end()) {
    // Axes of a bundle differ by sqrt(3) cells at the most.
    const PointGrid<3> points(reach_, 2 * tolerance_ + 4 * core::touching * reach_);
    bundle = bundles.insert(bundle, {fine, cone.axis, points});
  }
  bundle->points.insert(nearest_to_origin(cone.axis, cone.origin), number);
}

std::vector<int> RoundGrid::near(const Surface& round) const {
  std::vector<int> numbers;
  if (const auto* sphere = std::get_if<SphereSurface>(&round)) {
    spheres_.near(point_of(*sphere), numbers);
  } else {
    const auto& cone = std::get<ConeSurface>(round);
    constexpr double margin = 1.5 * core::parallel; // of near axes' coordinates, as of planes' normals
    for (const double turn : {1.0, -1.0}) {
      const std::array<int, 3> first = cell_of(cone.axis * turn, -margin),
                               last = cell_of(cone.axis * turn, margin);
      for (int x = first[0]; x <= last[0]; ++x)
        for (int y = first[1]; y <= last[1]; ++y)
          for (int z = first[2]; z <= last[2]; ++z) {
            const auto found = cones_.find({x, y, z});
            if (found == cones_.end()) continue;
            for (const Bundle& bundle : found->second)
              bundle.points.near(nearest_to_origin(bundle.axis, cone.origin), numbers);
          }
    }
  }
  std::sort(numbers.begin(), numbers.end()); // an axis near both ways is listed twice, which does no harm
  return numbers;
}

} // namespace halftone::scene
