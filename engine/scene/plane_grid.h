#pragma once
// Planes found by their normal and offset, so that not every face has to be compared with every plane.

#include "point_grid.h"

#include <halftone/scene/world.h>

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace halftone::scene {

/// Of unit vectors: those in one cell are the same up to the touching share, in each coordinate.
using FineCell = std::array<std::int64_t, 3>;
FineCell fine_cell(const Vec3& direction);

class PlaneGrid {
public:
  /// For planes of faces whose points are within `reach` of the origin. Two planes are near each other if the
  /// sine of their angle is at most `parallel` (up to 2^-9), and some such point of the one is within
  /// `tolerance` of the other.
  PlaneGrid(double reach, double parallel, double tolerance);

  /// number: larger than those before it.
  void insert(const Plane& plane, int number);

  /// The numbers of all planes that are near this one and within the tolerance of this point of it, and of
  /// some that are not; ascending.
  std::vector<int> near(const Plane& plane, const Vec3& point) const;

private:
  using Cell = std::array<int, 4>; ///< of the normal's coordinates and the offset

  /// Planes that are parallel, as those of many boxes are, by their offset.
  struct Bundle {
    FineCell fine{};
    Vec3 normal{0}; ///< of the first
    std::multimap<double, int> by_offset;
  };

  double normal_margin_; ///< how far coordinates of near planes' normals can be apart
  double offset_margin_;
  double offset_cell_;   ///< size of a cell of offsets
  double bundle_margin_; ///< of offsets in a bundle
  std::unordered_map<Cell, std::vector<Bundle>, CellHash> cells_;
};

} // namespace halftone::scene
