#include "povray_parts.h"
#include "words.h"

#include <array>

namespace halftone::convert {

namespace {

using core::Vec3;
using scene::Body;
using scene::Face;
using scene::World;

std::string triangle(const Body& body, const Face& face, std::size_t k) {
  const std::array<Vec3, 3> corners{face.outline[0], face.outline[k], face.outline[k + 1]};
  std::string result = face.rounded ? "  smooth_triangle {" : "  triangle {";
  for (std::size_t i = 0; i < 3; ++i) {
    result += (i > 0 ? ", " : " ") + vector_of(corners[i]);
    if (face.rounded) result += ", " + vector_of(scene::normal_at(*body.round, corners[i]));
  }
  return result + " }\n";
}

/// Faces as triangles, which POV-Ray finds faster than a polygon or an intersection of planes.
std::string mesh(const Body& body) {
  std::string result = "mesh {\n";
  for (const Face& face : body.faces)
    for (std::size_t k = 1; k + 1 < face.outline.size(); ++k) result += triangle(body, face, k);
  return result;
}

/// Glass is a true solid: the half-spaces of its faces.
std::string half_spaces(const World& world, const Body& body) {
  std::string result = "intersection {\n";
  for (const Face& face : body.faces) {
    const auto& plane = std::get<scene::Plane>(world.surfaces[face.surface]);
    const double side = face.flipped ? -1 : 1;
    result += "  plane { " + vector_of(side * plane.normal) + ", " + text(side * plane.offset) + " }\n";
  }
  return result + "  bounded_by { box { " + vector_of(body.bounds[0]) + ", " + vector_of(body.bounds[1]) +
         " } }\n";
}

std::string round_shape(const World& world, const Body& body) {
  if (body.kind == scene::BodyKind::sphere) {
    const auto& sphere = std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]);
    return "sphere {\n  " + vector_of(sphere.center) + ", " + text(sphere.radius) + "\n";
  }
  const scene::Frustum& f = *body.frustum;
  if (f.base_radius == f.top_radius)
    return "cylinder {\n  " + vector_of(f.base) + ", " + vector_of(f.top) + ", " + text(f.base_radius) + "\n";
  return "cone {\n  " + vector_of(f.base) + ", " + text(f.base_radius) + ", " + vector_of(f.top) + ", " +
         text(f.top_radius) + "\n";
}

} // namespace

std::string povray_body(const World& world, const Body& body) {
  const bool round = body.kind == scene::BodyKind::sphere || body.kind == scene::BodyKind::frustum;
  const bool glass = world.materials[body.material].glass.has_value();
  const std::string shape =
      round ? round_shape(world, body) : (glass ? half_spaces(world, body) : mesh(body));
  return shape + "  material { material_" + std::to_string(body.material) + " }\n}\n";
}

} // namespace halftone::convert
