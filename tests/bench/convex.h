#pragma once
// Convex solids met by lines in double precision, laid out for a ray tracer: Embree has floats, and its users
// bring their own code where those do not do.

#include <halftone/scene/world.h>

#include <optional>
#include <vector>

namespace halftone::bench {

using core::Vec3;

struct Line {
  Vec3 origin{0};
  Vec3 direction{0}; ///< unit length
};

/// The part of a line within a solid. Faces are indices into Body::faces.
struct Span {
  double in = 0;
  double out = 0;
  int in_face = -1;
  int out_face = -1;
};

class Convex {
public:
  /// A solid of the world, not a polygon.
  Convex(const scene::World& world, int body);

  std::optional<Span> cut(const Line& line) const;
  bool contains(const Vec3& point) const; ///< strictly
  int body() const { return body_; }

private:
  struct HalfSpace {
    Vec3 normal{0};
    double offset = 0;
    int face = -1;
  };

  bool clip_by_planes(const Line& line, Span& span) const;
  bool clip_by_sphere(const Line& line, Span& span) const;
  bool clip_by_cone(const Line& line, Span& span) const;

  int body_ = -1;
  scene::BodyKind kind_ = scene::BodyKind::polyhedron;
  std::vector<HalfSpace>
      planes_; ///< all faces of a polyhedron, the discs of a frustum, also where one is a point
  scene::SphereSurface sphere_;
  scene::ConeSurface cone_;
};

} // namespace halftone::bench
