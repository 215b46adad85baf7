#include <halftone/scene/world.h>

#include "contact.h"
#include "place.h"

#include <halftone/core/elementary.h>
#include <halftone/core/memory.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halftone::scene {

namespace {

CameraFrame camera_frame(const Camera& camera, const Image& image) {
  CameraFrame frame;
  frame.eye = camera.eye;
  frame.width = image.width;
  frame.height = image.height;
  frame.forward = glm::normalize(camera.target - camera.eye);
  const Vec3 right = glm::normalize(glm::cross(frame.forward, glm::normalize(camera.up)));
  const auto [sin, cos] = core::sin_cos(camera.fov * (std::numbers::pi / 360));
  const double half_height = sin / cos;
  frame.up = glm::cross(right, frame.forward) * half_height;
  frame.right = right * (half_height * image.width / image.height);
  return frame;
}

bool is_round(const Shape& shape) {
  return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Frustum>(shape);
}

bool is_traced(const Object& object, const Material& material) {
  if (object.trace != TraceRule::automatic) return object.trace == TraceRule::always;
  return material.glass || material.mirror != core::black || is_round(object.shape);
}

/// The cell boundary of the pattern along one axis that a flat face lies in, if any.
std::optional<double> pattern_edge(const PlacedFace& face, int axis, double cell, double tolerance) {
  if (!std::holds_alternative<Plane>(face.surface)) return std::nullopt;
  const double position = face.outline.empty() ? face.disc_center[axis] : face.outline[0][axis];
  const double edge = std::round(position / cell);
  Plane boundary{Vec3{0}, edge * cell};
  boundary.normal[axis] = 1;
  if (farthest_from(boundary, face) > tolerance) return std::nullopt;
  return edge;
}

} // namespace

Vec3 quadric_normal_at(const Surface& quadric, const Vec3& point) {
  if (const auto* sphere = std::get_if<SphereSurface>(&quadric))
    return glm::normalize(point - sphere->center);
  const auto& cone = std::get<ConeSurface>(quadric);
  const Vec3 from_origin = point - cone.origin;
  const Vec3 from_axis = from_origin - cone.axis * glm::dot(cone.axis, from_origin);
  const double distance = glm::length(from_axis);
  if (distance == 0) return cone.slope > 0 ? -cone.axis : cone.axis; // the apex
  return glm::normalize(from_axis / distance - cone.axis * cone.slope);
}

Vec3 CameraFrame::direction(double x, double y) const {
  return glm::normalize(forward + right * (2 * x / width - 1) + up * (1 - 2 * y / height));
}

World make_world(const Scene& scene) {
  World world;
  world.image = scene.image;
  world.camera = camera_frame(scene.camera, scene.image);
  world.background = scene.background;
  world.ambient = scene.ambient;
  world.trace = scene.trace;
  world.lights = scene.lights;
  world.materials = scene.materials;

  std::vector<PlacedBody> placed;
  for (const Object& object : scene.objects) {
    placed.push_back(place(object, scene.trace.facets));
    for (const Vec3& corner : placed.back().bounds)
      world.extent = std::max(world.extent, core::max_component(glm::abs(corner)));
  }
  std::vector<std::vector<int>> surface_of;
  const double tolerance = touching_distance(world);
  world.surfaces = share_surfaces(placed, tolerance, surface_of);

  for (std::size_t b = 0; b < placed.size(); ++b) {
    const Object& object = scene.objects[b];
    const Material& material = scene.materials[object.material];
    Body body;
    body.kind = placed[b].kind;
    body.material = object.material;
    body.traced = is_traced(object, material);
    body.frustum = placed[b].frustum;
    body.round = placed[b].round;
    body.bounds = placed[b].bounds;
    for (std::size_t f = 0; f < placed[b].faces.size(); ++f) {
      PlacedFace& source = placed[b].faces[f];
      Face face;
      face.surface = surface_of[b][f];
      face.rounded = source.rounded;
      if (const auto* own = std::get_if<Plane>(&source.surface))
        face.flipped = glm::dot(own->normal, std::get<Plane>(world.surfaces[face.surface]).normal) < 0;
      if (const auto& checker = material.checker) {
        face.pattern_edge = {pattern_edge(source, checker->axis_a, checker->size, tolerance),
                             pattern_edge(source, checker->axis_b, checker->size, tolerance)};
      }
      face.outline = std::move(source.outline);
      body.faces.push_back(std::move(face));
    }
    world.bodies.push_back(std::move(body));
  }
  return world;
}

std::size_t memory_of(const World& world) {
  using core::memory_of;
  return sizeof(World) + memory_of(world.lights) + memory_of(world.materials) + memory_of(world.surfaces) +
         memory_of(world.bodies, [](const Body& body) {
           return memory_of(body.faces, [](const Face& face) { return memory_of(face.outline); });
         });
}

Scene scanline_scene(const Scene& scene) {
  Scene result = scene;
  for (Material& material : result.materials) {
    material.mirror = core::black;
    if (!material.glass) continue;
    material.diffuse = material.opaque;
    material.glass.reset();
    material.checker.reset(); // a pattern never replaces the opaque albedo
  }
  for (Object& object : result.objects)
    object.trace = is_round(object.shape) ? TraceRule::never : TraceRule::automatic;
  return result;
}

} // namespace halftone::scene
