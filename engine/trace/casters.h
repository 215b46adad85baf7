#pragma once
// The bodies that can stand between a light and anything, each with the cone around it as the light sees it.

#include <halftone/geometry/bounds_tree.h>
#include <halftone/scene/world.h>

#include <vector>

namespace halftone::trace {

/// Opaque bodies first, then glass; in arrays, one for each number.
class Casters {
public:
  Casters(const scene::World& world, const core::Vec3& light);

  /// Which casters a segment from the light can meet. direction: of unit length, away from the light. The
  /// result stands in `memory`, which grows at need.
  struct Found {
    const int* opaque = nullptr;
    const int* glass = nullptr; ///< also the end of the opaque ones
    const int* end = nullptr;
  };
  Found gather(const core::Vec3& direction, double distance, std::vector<int>& memory) const;

  /// Which casters segments can meet whose directions lie in a box; in no particular order.
  struct Lists {
    std::vector<int> opaque;
    std::vector<int> glass;

    std::size_t size() const { return opaque.size() + glass.size(); }
  };
  void gather(const geometry::Bounds& directions, Lists& lists) const;

  /// Whether a body is among them.
  bool include(int body) const { return is_caster_[body]; }

  /// Bytes that they hold.
  std::size_t memory() const;

private:
  std::vector<bool> is_caster_; ///< one for each body
  std::vector<int> bodies_;
  std::size_t opaque_ = 0;          ///< number of opaque casters
  std::vector<double> x_, y_, z_;   ///< unit vector from the light to the body's middle
  std::vector<double> cosine_;      ///< of the largest angle from it
  std::vector<double> from_;        ///< the body is no nearer to the light
  geometry::BoundsTree directions_; ///< boxes around the cones' directions
};

} // namespace halftone::trace
