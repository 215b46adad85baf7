#pragma once
// Points found by their coordinates: a hash grid in any number of dimensions.

#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace halftone::scene {

/// Of a cell's coordinates.
struct CellHash {
  template<typename Cell>
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t key = 0;
    for (const auto coordinate : cell)
      key = (key + static_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15U;
    return key ^ key >> 32;
  }
};

template<std::size_t dimensions>
class PointGrid {
public:
  using Point = std::array<double, dimensions>;

  /// reach: the largest coordinate. Points are near each other if no coordinate differs by more than
  /// `margin` > 0. Where that is no small share of the reach, cells are as large.
  PointGrid(double reach, double margin)
      : margin_(margin),
        cell_size_(std::max(core::point_cell * reach, margin)) {}

  void insert(const Point& point, int number) { cells_[cell_of(point, 0)].push_back(number); }

  /// Adds the numbers of all points that are near this one, and of some that are not.
  void near(const Point& point, std::vector<int>& numbers) const {
    const Cell first = cell_of(point, -margin_), last = cell_of(point, margin_);
    Cell cell = first;
    for (std::size_t axis = 0; axis < dimensions;) {
      const auto found = cells_.find(cell);
      if (found != cells_.end()) numbers.insert(numbers.end(), found->second.begin(), found->second.end());
      // The next cell, as numbers are counted.
      for (axis = 0; axis < dimensions && ++cell[axis] > last[axis]; ++axis) cell[axis] = first[axis];
    }
  }

private:
  using Cell = std::array<std::int64_t, dimensions>;

  Cell cell_of(const Point& point, double moved) const {
    Cell cell;
    for (std::size_t axis = 0; axis < dimensions; ++axis)
      cell[axis] = static_cast<std::int64_t>(std::floor((point[axis] + moved) / cell_size_));
    return cell;
  }

  double margin_;
  double cell_size_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

} // namespace halftone::scene
