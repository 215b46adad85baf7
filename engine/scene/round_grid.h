#pragma once
// Spheres and cones found by where they are, so that not every one has to be compared with every other.

#include "plane_grid.h"
#include "point_grid.h"

namespace halftone::scene {

class RoundGrid {
public:
  /// reach: the largest distance of a sphere's center or a cone's origin from the world's, and the largest
  /// radius of a sphere. tolerance: how far coinciding surfaces may be apart.
  RoundGrid(double reach, double tolerance);

  /// number: larger than those before it.
  void insert(const Surface& round, int number);

  /// The numbers of all surfaces that may coincide with this one: spheres whose centers and radii, or cones
  /// on whose axis its origin is within the tolerance, the sine of the axes' angle being at most
  /// core::parallel; and of some others. Ascending.
  std::vector<int> near(const Surface& round) const;

private:
  /// Cones whose axes have nearly the same direction, by the point of the axis that is nearest to the origin.
  struct Bundle {
    FineCell fine{};
    Vec3 axis{0}; ///< of the first
    PointGrid<3> points;
  };

  double reach_;
  double tolerance_;
  PointGrid<4> spheres_;                                                        ///< center and radius
  std::unordered_map<std::array<int, 3>, std::vector<Bundle>, CellHash> cones_; ///< by the axis
};

} // namespace halftone::scene
