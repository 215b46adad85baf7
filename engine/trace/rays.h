#pragma once
// A queue of rays of one depth, as a structure of arrays.

#include <halftone/geometry/line.h>

#include <cstdint>
#include <span>
#include <vector>

namespace halftone::trace {

using core::Color;
using core::Vec3;

/// A face of a body.
struct Met {
  int body = -1;
  int face = -1;
};

/// What touches a surface from one side, as a ray in the gap on the surface meets it at distance zero.
struct Touching {
  Met opaque;    ///< the opaque surface that is seen there; body < 0: none
  int first = 0; ///< of Rays::mets: the glass solids that begin there
  int count = 0;
};

/// The gap on a surface where solids touch, as a ray in it that goes to one side finds it.
struct Gap {
  Touching ahead;
  Touching behind;
};

inline Gap turned(const Gap& gap) { return {gap.behind, gap.ahead}; }

/// One entry a ray in every array. Arrays may be longer than the queue.
struct Rays {
  std::vector<double> origin_x, origin_y, origin_z;
  std::vector<double> direction_x, direction_y, direction_z;
  std::vector<double> weight_r, weight_g, weight_b;
  std::vector<int> surface; ///< that the ray starts on, or -1
  std::vector<std::uint8_t> outward;
  std::vector<int> inside; ///< a set of InsideSets
  std::vector<std::uint8_t> in_gap;
  std::vector<Gap> gap; ///< where in_gap
  std::vector<int> sample;

  std::vector<Met> mets; ///< that the gaps refer to
  std::size_t count = 0;

  /// A new ray's place, its entries not set.
  std::size_t add() {
    if (count == sample.size()) grow();
    return count++;
  }
  void clear() {
    count = 0;
    mets.clear();
  }

  geometry::Line line(std::size_t i) const { return {origin(i), direction(i), surface[i], outward[i] != 0}; }
  Vec3 origin(std::size_t i) const { return {origin_x[i], origin_y[i], origin_z[i]}; }
  Vec3 direction(std::size_t i) const { return {direction_x[i], direction_y[i], direction_z[i]}; }
  Color weight(std::size_t i) const { return {weight_r[i], weight_g[i], weight_b[i]}; }
  void set_origin(std::size_t i, const Vec3& v) { origin_x[i] = v.x, origin_y[i] = v.y, origin_z[i] = v.z; }
  void set_direction(std::size_t i, const Vec3& v) {
    direction_x[i] = v.x, direction_y[i] = v.y, direction_z[i] = v.z;
  }
  void set_weight(std::size_t i, const Color& w) { weight_r[i] = w.r, weight_g[i] = w.g, weight_b[i] = w.b; }

  std::span<const Met> entries(const Touching& touching) const {
    return {mets.data() + touching.first, static_cast<std::size_t>(touching.count)};
  }

  /// A gap of another queue's ray, for a ray of this one.
  Gap adopted(const Gap& theirs, const Rays& from);

private:
  void grow();
  Touching adopted(const Touching& touching, const Rays& from);
};

} // namespace halftone::trace
