// A hash grid over the normal and the offset of planes. Near planes n, d and m, e (m turned if need be to be
// nearest to n) have |n - m| <= sqrt(2) s for a sine s of their angle up to 1/2, and at a common point p
// within the tolerance |d - e| <= |n - m| |p| + tolerance. Cells are 2^-8 of what can occur, several times
// the margins; where a sphere of a far larger extent makes the tolerance larger than that, they are the
// margin.
//
// Boxes that stand alike have as many planes in one cell as there are boxes. So a cell keeps its planes in
// bundles whose normals are the same up to the touching share e, |n - n0| <= sqrt(3) e, by their offsets:
// where p is within the tolerance of one of them, its offset is within tolerance + sqrt(3) e |p| of n0 . p.

#include "plane_grid.h"

#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <cmath>

namespace halftone::scene {

namespace {

using core::plane_cell; // of normals; of offsets, times the reach

int cell_of(double value, double size) { return static_cast<int>(std::floor(value / size)); }

} // namespace

PlaneGrid::PlaneGrid(double reach, double parallel, double tolerance)
    : normal_margin_(1.5 * parallel),
      offset_margin_(1.5 * parallel * reach + 2 * tolerance),
      offset_cell_(std::max(plane_cell * reach, offset_margin_)),
      bundle_margin_(2 * tolerance + 2 * core::touching * reach) {}

FineCell fine_cell(const Vec3& direction) {
  FineCell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<std::int64_t>(std::floor(direction[axis] / core::touching));
  return cell;
}

void PlaneGrid::insert(const Plane& plane, int number) {
  std::vector<Bundle>& bundles =
      cells_[{cell_of(plane.normal.x, plane_cell), cell_of(plane.normal.y, plane_cell),
              cell_of(plane.normal.z, plane_cell), cell_of(plane.offset, offset_cell_)}];
  const FineCell fine = fine_cell(plane.normal);
  auto bundle = std::find_if(bundles.begin(), bundles.end(), [&](const Bundle& b) { return b.fine == fine; });
  if (bundle == bundles.end()) bundle = bundles.insert(bundle, {fine, plane.normal, {}});
  bundle->by_offset.emplace(plane.offset, number);
}

std::vector<int> PlaneGrid::near(const Plane& plane, const Vec3& point) const {
  std::vector<int> numbers;
  for (const double turn : {1.0, -1.0}) {
    const core::Vec3 normal = plane.normal * turn;
    const double offset = plane.offset * turn;
    Cell first, last;
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = cell_of(normal[axis] - normal_margin_, plane_cell);
      last[axis] = cell_of(normal[axis] + normal_margin_, plane_cell);
    }
    first[3] = cell_of(offset - offset_margin_, offset_cell_);
    last[3] = cell_of(offset + offset_margin_, offset_cell_);
    for (int x = first[0]; x <= last[0]; ++x)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int z = first[2]; z <= last[2]; ++z)
          for (int d = first[3]; d <= last[3]; ++d) {
            const auto found = cells_.find({x, y, z, d});
            if (found == cells_.end()) continue;
            for (const Bundle& bundle : found->second) {
              const double own = glm::dot(bundle.normal, point);
              auto each = bundle.by_offset.lower_bound(own - bundle_margin_);
              const auto end = bundle.by_offset.upper_bound(own + bundle_margin_);
              for (; each != end; ++each) numbers.push_back(each->second);
            }
          }
  }
  std::sort(numbers.begin(), numbers.end()); // a plane near both ways is listed twice, which does no harm
  return numbers;
}

} // namespace halftone::scene
