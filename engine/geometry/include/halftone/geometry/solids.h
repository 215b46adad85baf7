#pragma once
// Line ∩ body, for all bodies of a world, which are laid out in flat arrays: planes of a polyhedron side by
// side. Faces that share a surface are met at the same t, to the bit.

#include <halftone/geometry/line.h>
#include <halftone/scene/world.h>

#include <optional>
#include <vector>

namespace halftone::geometry {

/// A cone surface with a frame of its own. u, v and axis are orthonormal.
struct FramedCone {
  Vec3 origin{0};
  Vec3 u{0}, v{0}, axis{0};
  double radius = 0; ///< at the origin
  double slope = 0;  ///< growth of the radius along the axis
};

/// What all bodies of a world are for lines, in flat arrays.
struct SolidTable {
  /// The normal of the plane as the body's face has it, the offset to match.
  struct OutwardPlane {
    Vec3 normal{0};
    double offset = 0;
  };
  struct PlaneSurface {
    int surface = 0;
    bool flipped = false; ///< outward is opposite to the surface's own normal
    bool under_eye = false;
  };

  /// Where a body's parts stand in the arrays.
  struct Parts {
    scene::BodyKind kind{};
    int first = 0; ///< of planes
    int count = 0;
    int round = -1;         ///< of spheres or cones
    int round_surface = -1; ///< of the sphere or the frustum's side, which is face 0
    int corner = 0;         ///< of corners
    int corners = 0;
    double reach = 0; ///< of a polygon: the greatest length of a corner
  };

  std::vector<Parts> parts; ///< one for each body
  std::vector<OutwardPlane> planes;
  std::vector<PlaneSurface> plane_surfaces; ///< one for each plane
  std::vector<scene::SphereSurface> spheres;
  std::vector<FramedCone> cones;
  std::vector<Vec3> corners; ///< of polygons
};

struct Range;

class Solids {
public:
  /// Keeps nothing of the world.
  explicit Solids(const scene::World& world);

  /// Where the line runs in the solid, t < 0 too; in.t < out.t. Nothing where that is nowhere ahead: out.t >
  /// 0.
  std::optional<Span> span(int solid, const Line& line) const;

  /// Where a line that is inside the solid, as a fact, leaves it: t >= 0 whatever rounding says.
  Crossing exit(int solid, const Line& line) const;

  /// Where a line with t > 0 crosses a polygon; nothing where it starts on the polygon's surface. Of polygons
  /// that share edges and corners, to the bit, and tile what a line sees of them, it crosses exactly one.
  std::optional<Crossing> crossing(int polygon, const Line& line) const;

  /// Bytes that they hold.
  std::size_t memory() const;

  const SolidTable table;

private:
  using Parts = SolidTable::Parts;
  struct Pass;

  bool clip(const Parts& parts, const Line& line, Span& span) const;
  void limit(const Parts& parts, const Line& line, Crossing& out) const;
  Range round_range(const Parts& parts, const Line& line) const;
};

} // namespace halftone::geometry
