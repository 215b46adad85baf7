#pragma once
// A world in Embree: flat opaque things as triangles, glass and round things as user geometry that is met in
// double precision.
//
// Rays start on solids of user geometry without an epsilon: they are convex, so one that a ray is not in and
// has just left or reflected from is not met again, and one that it is in has only its far wall. The
// callbacks know from the ray's Query which those are. A ray that starts on a triangle has a `tnear`:
// Embree's own intersection is in floats, and a filter function would cost every ray more than it saves.

#include "convex.h"

#include <embree3/rtcore.h>

#include <array>
#include <span>

namespace halftone::bench {

/// The solids that a ray is in, in no order.
class InsideSet {
public:
  static constexpr int capacity = 16; ///< more solids in one another than that are refused

  bool has(int body) const {
    for (int i = 0; i < count_; ++i)
      if (bodies_[static_cast<std::size_t>(i)] == body) return true;
    return false;
  }
  void add(int body); ///< throws std::runtime_error where it is full
  void remove(int body);
  std::span<const int> all() const { return {bodies_.data(), static_cast<std::size_t>(count_)}; }

private:
  std::array<int, capacity> bodies_{};
  int count_ = 0;
};

/// What a ray meets.
struct Hit {
  double t = 0;
  int body = -1; ///< -1: nothing
  int face = -1;
};

/// A crossing of glass by a shadow ray.
struct GlassSpan {
  Span span;
  int body = -1;
};

class EmbreeScene {
public:
  /// The world must outlive this, the device too.
  EmbreeScene(RTCDevice device, const scene::World& world);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// start: the body whose surface the ray leaves, -1 for none.
  Hit nearest(const Line& line, int start, const InsideSet& inside) const;

  /// Whether an opaque surface lies between the ray's start and `distance`.
  bool is_dark(const Line& line, double distance, int start) const;

  /// All spans of glass solids on the line that reach into (0, distance). Valid until the thread's next call.
  std::span<const GlassSpan> glass_between(const Line& line, double distance, int start) const;

  InsideSet solids_around(const Vec3& point) const;
  bool has_glass() const { return !glass_.all.empty(); }

private:
  struct Triangle {
    int body = -1;
    int face = -1;
    scene::Plane plane;
  };
  struct Query;
  /// What the callbacks of a geometry of solids are given.
  struct Solids {
    const EmbreeScene* scene = nullptr;
    std::vector<Convex> all;
  };

  void add_triangles(RTCDevice device);
  void add_solids(RTCDevice device, Solids& solids, bool glass);
  /// Where a ray that leaves this body begins to look.
  float tnear(int start) const;

  static void bounds(const RTCBoundsFunctionArguments* arguments);
  static void meet(const RTCIntersectFunctionNArguments* arguments);
  static void shade_by_opaque(const RTCOccludedFunctionNArguments* arguments);
  static void collect_glass(const RTCOccludedFunctionNArguments* arguments);

  const scene::World& world_;
  Solids opaque_;
  Solids glass_;
  std::vector<Triangle> triangles_;
  std::vector<bool> is_flat_; ///< of bodies: made of triangles
  float epsilon_ = 0;
  RTCScene all_ = nullptr;
  RTCScene opaque_scene_ = nullptr;
  RTCScene glass_scene_ = nullptr;
};

} // namespace halftone::bench
