#pragma once
// A scene as plain values, as the file says it: object coordinates, degrees, linear RGB. Every value is valid
// once a reader has returned it (docs: the scene format). world.h says what it means in world space.

#include <halftone/core/vector.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halftone::scene {

using core::Color;
using core::Vec3;

enum class Transfer { srgb, linear };

struct Image {
  int width = 512; ///< pixels, 1 to 512
  int height = 512;
  double exposure = 1; ///< factor on radiance, > 0
  Transfer transfer = Transfer::srgb;
};

struct Camera {
  Vec3 eye{0};
  Vec3 target{0};
  Vec3 up{0, 0, 1};
  double fov = 40; ///< vertical field of view in degrees, 0 < fov < 180
};

struct Trace {
  int depth = 5;        ///< largest depth of the ray tree, the eye's ray having depth 1
  double cutoff = 0.01; ///< a branch whose weight's largest component is below this is not followed
  int facets = 24;      ///< sides of the polyhedron that stands for a round shape
};

/// A point light without distance fall-off.
struct Light {
  Vec3 position{0};
  Color color{0};
};

/// Where floor(a/size) + floor(b/size) is odd, in world coordinates of the two axes, the albedo is color.
struct Checker {
  Color color{0};
  double size = 1;
  int axis_a = 0; ///< 0, 1, 2 for x, y, z
  int axis_b = 1;
};

struct Glass {
  double ior = 1;      ///< index of refraction, > 0
  Color absorption{0}; ///< Beer-Lambert coefficient per scene unit
};

struct Material {
  std::string name;
  Color diffuse{0.8};
  Color specular{0};
  double shininess = 32;
  Color mirror{0};
  std::optional<Glass> glass;
  Color opaque{0.7, 0.8, 0.85}; ///< albedo of a glass object where it is drawn opaque
  std::optional<Checker> checker;
};

struct Sphere {
  Vec3 center{0};
  double radius = 0;
};

/// Cylinder, cone and truncated cone: equal radii, or one that is 0, not both.
struct Frustum {
  Vec3 base{0};
  Vec3 top{0};
  double base_radius = 0;
  double top_radius = 0;
};

struct Box {
  Vec3 min{0};
  Vec3 max{0};
};

struct Prism {
  Vec3 base{0};
  Vec3 top{0};
  double radius = 0;
  int sides = 3;
  double turn = 0; ///< degrees
};

/// Convex and closed, up to 1e-6 of the longest edge; the loops may run either way round. No vertex is
/// repeated within a loop, and faces that meet share indices; vertices at the place of an earlier one are not
/// used.
struct Polyhedron {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
};

/// Planar up to rounding, convex up to 1e-6 of the longest edge (vertices may lie on edges), seen from both
/// sides.
struct Polygon {
  std::vector<Vec3> vertices;
};

using Shape = std::variant<Sphere, Frustum, Box, Prism, Polyhedron, Polygon>;

/// automatic: glass, mirrors and round shapes are ray traced. never: the faceted stand-in is the object.
enum class TraceRule { automatic, always, never };

/// World point = translate + Rz Ry Rx (scale * p).
struct Placement {
  double scale = 1;
  Vec3 rotate{0}; ///< degrees about x, then y, then z
  Vec3 translate{0};
};

struct Object {
  std::string shape_name; ///< the file's word: "cylinder", "cone", ...
  std::string name;
  Shape shape;
  int material = 0; ///< index into Scene::materials
  TraceRule trace = TraceRule::automatic;
  Placement placement;
};

struct Scene {
  std::string title;
  Image image;
  Camera camera;
  Color background{0};
  Color ambient{0};
  Trace trace;
  std::vector<Light> lights;
  std::vector<Material> materials; ///< [0] is the default grey, then the file's, in its order
  std::vector<Object> objects;     ///< in file order, which is the priority of nested glass
};

} // namespace halftone::scene
