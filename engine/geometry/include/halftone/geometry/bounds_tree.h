#pragma once
// A hierarchy of boxes along the axes, to find those that a line passes or a box meets without asking all.
// Whatever the items are: bodies in the world, directions from a light, regions of the screen.

#include <halftone/core/memory.h>
#include <halftone/core/rounding.h>
#include <halftone/core/vector.h>

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace halftone::geometry {

using core::Vec3;

/// All points between two corners, which belong to it. Empty as it is made; coordinates may be infinite.
struct Bounds {
  Vec3 low{std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity()};

  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool meets(const Bounds& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
};

/// A half line, ready to be tested against many boxes.
class Ray {
public:
  Ray(const Vec3& origin, const Vec3& direction) : origin_(origin), inverse_(1.0 / direction) {}

  /// Whether the half line passes the box at a distance of at most `limit`. Never false where it does,
  /// whatever rounding does.
  bool passes(const Bounds& box, double limit) const {
    double in = 0, out = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const bool backwards = inverse_[axis] < 0;
      const double near = (backwards ? box.high : box.low)[axis] - origin_[axis];
      const double far = (backwards ? box.low : box.high)[axis] - origin_[axis];
      // Along a side of the box these are 0 times infinity, no numbers, and do not count.
      const double from = near * inverse_[axis], to = far * inverse_[axis];
      if (from > in) in = from;
      if (to < out) out = to;
    }
    // Either may be off by 3 roundings: T. Ize, "Robust BVH ray traversal", 2013, section 3.
    return in <= out * (1 + 2 * core::gamma(3)) && in * (1 - 2 * core::gamma(3)) <= limit;
  }

  bool is_backwards(int axis) const { return inverse_[axis] < 0; }

private:
  Vec3 origin_;
  Vec3 inverse_; ///< of the direction
};

class BoundsTree {
public:
  BoundsTree() = default;

  /// Of boxes numbered from 0. Empty ones are never found.
  explicit BoundsTree(std::span<const Bounds> boxes);

  /// Calls visit(number) for boxes that the half line may pass before `limit`, near ones about first. What
  /// visit returns is the limit from then on; below 0 nothing more is visited.
  template<typename Visit>
  void along(const Ray& ray, double limit, Visit visit) const {
    walk([&](const Bounds& box) { return ray.passes(box, limit); },
         [&](int axis) { return ray.is_backwards(axis); }, [&](int item) { limit = visit(item); });
  }

  /// Calls visit(number) for boxes that meet the given one, each once, in no particular order.
  template<typename Visit>
  void meeting(const Bounds& given, Visit visit) const {
    walk([&](const Bounds& box) { return box.meets(given); }, [](int) { return false; }, visit);
  }

  /// Bytes that it holds.
  std::size_t memory() const {
    return core::memory_of(nodes_) + core::memory_of(items_) + core::memory_of(boxes_);
  }

private:
  /// Halves follow each other: the first is the next node, the second is named.
  struct Node {
    Bounds box;
    int second = 0; ///< of an inner node
    int first = 0;  ///< of items_, of a leaf
    int count = 0;  ///< of items; 0: an inner node
    int axis = 0;   ///< across which an inner node is split, lower half first
  };
  struct Building;

  template<typename Wanted, typename Backwards, typename Visit>
  void walk(Wanted wanted, Backwards backwards, Visit visit) const {
    if (nodes_.empty()) return;
    std::array<int, most_depth> open;
    int opened = 0, at = 0;
    for (;;) {
      const Node& node = nodes_[at];
      if (wanted(node.box)) {
        if (node.count == 0) {
          const bool second_first = backwards(node.axis);
          open[opened++] = second_first ? at + 1 : node.second;
          at = second_first ? node.second : at + 1;
          continue;
        }
        for (int k = node.first; k < node.first + node.count; ++k)
          if (wanted(boxes_[k])) visit(items_[k]);
      }
      if (opened == 0) return;
      at = open[--opened];
    }
  }

  static constexpr int most_depth = 64;

  void build(std::span<Building> items, int depth);

  std::vector<Node> nodes_;
  std::vector<int> items_;    ///< leaf by leaf
  std::vector<Bounds> boxes_; ///< one for each of items_
};

} // namespace halftone::geometry
