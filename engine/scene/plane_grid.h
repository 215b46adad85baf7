#pragma once
// Planes found by their normal and offset, so that not every face has to be compared with every plane.

#include <halftone/scene/world.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace halftone::scene {

class PlaneGrid {
public:
  /// For planes of faces whose points are within `reach` of the origin. Two planes are near each other if the
  /// sine of their angle is at most `parallel` (up to 2^-9), and some such point of the one is within
  /// `tolerance` of the other.
  PlaneGrid(double reach, double parallel, double tolerance);

  /// number: larger than those before it.
  void insert(const Plane& plane, int number);

  /// The numbers of all planes that are near this one, and of some that are not; ascending.
  std::vector<int> near(const Plane& plane) const;

private:
  using Cell = std::array<int, 4>; ///< of the normal's coordinates and the offset
  struct Hash {
    std::size_t operator()(const Cell& cell) const;
  };

  double normal_margin_; ///< how far coordinates of near planes' normals can be apart
  double offset_margin_;
  double offset_cell_; ///< size of a cell of offsets
  std::unordered_map<Cell, std::vector<int>, Hash> cells_;
};

} // namespace halftone::scene
