#pragma once
// What a scene means in world space: bodies bounded by faces, each face on a surface. All that has to be
// decided once is decided here, so that nothing later depends on rounding: which faces coincide (they share
// one surface, so a line meets them at the same distance to the bit), where a face lies in a plane of its own
// pattern, which objects are drawn as faceted stand-ins, which are ray traced.
//
// World space: right-handed, scene units. Normals have unit length.

#include <halftone/core/small_numbers.h>

#include <halftone/scene/scene.h>

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace halftone::scene {

/// dot(normal, x) = offset.
struct Plane {
  Vec3 normal{0, 0, 1};
  double offset = 0;
};

struct SphereSurface {
  Vec3 center{0};
  double radius = 0;
};

/// The side of cylinders, cones and truncated cones: at height h = dot(axis, x - origin) its radius is
/// radius + slope * h. Only the nappe where that is >= 0 belongs to it.
struct ConeSurface {
  Vec3 origin{0};
  Vec3 axis{0, 0, 1};
  double radius = 0;
  double slope = 0;
};

using Surface = std::variant<Plane, SphereSurface, ConeSurface>;

/// Outward unit normal of a sphere or a cone at a point on it.
Vec3 quadric_normal_at(const Surface& quadric, const Vec3& point);

/// Unit normal of a surface at a point on it: a plane's own, a quadric's outward one.
inline Vec3 normal_at(const Surface& surface, const Vec3& point) {
  const auto* plane = std::get_if<Plane>(&surface);
  return plane ? plane->normal : quadric_normal_at(surface, point);
}

struct Face {
  int surface = 0;      ///< index into World::surfaces; equal for faces that coincide
  bool flipped = false; ///< the outward normal is opposite to the plane's
  bool rounded = false; ///< a side of a stand-in, shaded with the normal of Body::round
  /// Corners in world space, counter-clockwise seen from outside; empty for round faces and for discs.
  std::vector<Vec3> outline;
  /// Cell boundary of the material's pattern, in cells, for each of its two axes, where the face lies in it.
  std::array<std::optional<double>, 2> pattern_edge;
};

enum class BodyKind { polyhedron, sphere, frustum, polygon };

/// A convex solid, or a polygon. faces: of a polyhedron all; of a sphere one; of a frustum the side, then a
/// disc for each end whose radius is not 0, base first; of a polygon one, whose plane's normal is its own.
struct Body {
  BodyKind kind = BodyKind::polyhedron;
  int material = 0;
  bool traced = false; ///< mode local traces rays for it (the scene format, section 5)
  std::vector<Face> faces;
  std::optional<Frustum> frustum; ///< of a frustum: its ends, in world space
  std::optional<Surface> round;   ///< the round surface that a faceted stand-in stands for
  std::array<Vec3, 2> bounds{};   ///< least and greatest corner of a box around it
};

/// Image position to direction (the scene format, section 2).
struct CameraFrame {
  Vec3 eye{0};
  Vec3 forward{0};
  Vec3 right{0}; ///< scaled: half the picture's width at distance 1
  Vec3 up{0};    ///< scaled: half the picture's height at distance 1
  int width = 0;
  int height = 0;

  /// Unit direction through continuous image position (x right, y down, pixels).
  Vec3 direction(double x, double y) const;
};

struct World {
  Image image;
  CameraFrame camera;
  Color background{0};
  Color ambient{0};
  Trace trace;
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<Surface> surfaces;
  std::vector<Body> bodies; ///< one for each object, in file order
  double extent = 0;        ///< largest absolute coordinate of any object
};

/// Distance below which faces of different objects coincide, in scene units (the scene format, section 3).
inline double touching_distance(const World& world) { return world.extent * core::touching; }

/// The meaning of a valid scene.
World make_world(const Scene& scene);

/// Bytes that the world takes.
std::size_t memory_of(const World& world);

/// The scene as mode scanline draws it: glass opaque with its own albedo, mirrors dark, round shapes faceted.
Scene scanline_scene(const Scene& scene);

} // namespace halftone::scene
