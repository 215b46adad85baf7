#pragma once
// A ball around every body, to turn away most lines before the exact test.

#include <halftone/geometry/bounds_tree.h>
#include <halftone/geometry/line.h>
#include <halftone/scene/world.h>

#include <span>
#include <vector>

namespace halftone::geometry {

/// Whatever rounding does in Solids, a line that meets the body passes within radius + growth * d of the
/// center, d being the distance of the line's origin from the center, and meets the body there. growth may be
/// infinite.
struct Ball {
  Vec3 center{0};
  double radius = 0;
  double growth = 0;
};

Ball bounding_ball(const scene::World& world, const scene::Body& body);

/// Whatever rounding does in Solids, a line whose origin is within `reach` of the world's origin meets the
/// body in this box, or not at all. It may be infinite.
Bounds bounding_box(const scene::World& world, const scene::Body& body, double reach);

/// A body that a line may meet.
struct Near {
  int body = -1;
  double from = 0; ///< not before this t
};

/// The balls of all bodies in arrays, one for each number.
class Balls {
public:
  explicit Balls(const scene::World& world);

  /// All bodies that the line may meet at t >= 0, ascending. The result stands in `memory`, which grows at
  /// need.
  std::span<const Near> gather(const Line& line, std::vector<Near>& memory) const;

  /// Bytes that they hold.
  std::size_t memory() const;

  /// What gather() and may_meet() calculate with, of one body.
  struct Bound {
    Vec3 center{0};
    double reach_squared = 0, kept = 0, nearer = 0, before = 0;
  };
  Bound bound(std::size_t b) const {
    return {{x_[b], y_[b], z_[b]}, reach_squared_[b], kept_[b], nearer_[b], before_[b]};
  }

  /// The same question for one body.
  bool may_meet(int body, const Line& line) const {
    const Vec3 to_center = center_from(body, line);
    return !is_missed(body, glm::dot(to_center, to_center), glm::dot(to_center, line.direction));
  }

private:
  Vec3 center_from(std::size_t b, const Line& line) const {
    return {x_[b] - line.origin.x, y_[b] - line.origin.y, z_[b] - line.origin.z};
  }
  /// By the squared distance of the center from the line's origin and its distance along the line. False, as
  /// it should be, where numbers are not finite.
  bool is_missed(std::size_t b, double squared, double along) const {
    const double ahead = along > 0 ? along : 0;
    return kept_[b] * squared > reach_squared_[b] + ahead * ahead;
  }

  std::vector<double> x_, y_, z_; ///< centers
  std::vector<double> reach_squared_;
  std::vector<double> kept_;   ///< of a squared distance after all that rounding can add to it
  std::vector<double> nearer_; ///< Near::from is at least the distance along the line times this,
  std::vector<double> before_; ///< less this
};

} // namespace halftone::geometry
