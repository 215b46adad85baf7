// Luminance of an ordinary interval (Tadamura, Nakamae, Nishita c. 1986, section 3.4.2).

#include "flat_shading.h"

#include <halftone/shade/albedo.h>
#include <halftone/shade/local.h>

#include <algorithm>

namespace halftone::scan {

namespace {

struct FlatPoint {
  shade::SurfacePoint point;
  std::optional<shade::Cell> cell; ///< of the pattern
  /// The round surface's normal looks away from the eye, as it does near a stand-in's outline.
  bool turned = false;
};

FlatPoint surface_point(const Frame& frame, const ScreenFace& face, double x, double y) {
  const scene::Body& body = frame.world.bodies[face.body];
  const scene::Face& own = body.faces[face.face];
  const scene::Material& material = frame.world.materials[body.material];
  const core::Vec3 direction = frame.screen.direction(x, y);
  shade::SurfacePoint point;
  point.position = frame.world.camera.eye + direction / face.inverse_depth.at(x, y);
  point.direction = glm::normalize(direction);
  point.normal = scene::normal_at(frame.world.surfaces[own.surface], point.position);
  if (glm::dot(point.normal, direction) > 0) point.normal = -point.normal;
  const auto cell = shade::cell(material, own, point.position, point.normal);
  point.albedo = shade::albedo(material, cell);
  point.specular = material.specular;
  point.shininess = material.shininess;
  if (!own.rounded) return {point, cell, false};
  point.normal = scene::normal_at(*body.round, point.position);
  const bool turned = glm::dot(point.normal, direction) > 0;
  if (turned) point.normal = -point.normal;
  return {point, cell, turned};
}

/// Then n . l = 0, as a fact.
bool lies_in(const Frame& frame, int light, int surface) {
  const std::vector<int>& planes = frame.light_planes[light];
  return std::binary_search(planes.begin(), planes.end(), surface);
}

} // namespace

FlatRun::FlatRun(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
                 const std::optional<core::Color>& albedo)
    : frame_(frame),
      own_(frame.world.bodies[face.body].faces[face.face]),
      material_(frame.world.materials[frame.world.bodies[face.body].material]),
      albedo_(albedo),
      terms_{frame.world.camera,
             face.inverse_depth,
             core::Vec3{0},
             frame.world.ambient,
             material_.specular,
             material_.shininess,
             {}},
      shade_(shade_flat_with(frame.simd)) {
  const auto& plane = std::get<scene::Plane>(frame.world.surfaces[own_.surface]);
  const auto height = [&](const core::Vec3& point) { return glm::dot(plane.normal, point) - plane.offset; };
  const bool is_before = height(frame.world.camera.eye) > 0;
  terms_.normal = is_before ? plane.normal : -plane.normal;
  for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
    const scene::Light& light = frame.world.lights[i];
    const double over = height(light.position);
    if (!lights[i].dark && (is_before ? over : -over) > 0 && !lies_in(frame, i, own_.surface))
      terms_.lights.push_back(light);
  }
}

core::Vec3 FlatRun::position(double x, double y) const {
  return frame_.world.camera.eye + frame_.screen.direction(x, y) / terms_.inverse_depth.at(x, y);
}

FlatRun::Reflecting FlatRun::reflecting(const view::ScreenPoint& at) const {
  if (albedo_) return {*albedo_, 0};
  if (!material_.checker) return {material_.diffuse, 0};
  const auto cell = shade::cell(material_, own_, position(at.x, at.y), terms_.normal);
  return {shade::albedo(material_, cell), cell->is_odd() ? 2u : 0u};
}

core::Color FlatRun::radiance(double x, double y, const core::Color& albedo) const {
  const shade::SurfacePoint point{position(x, y),  glm::normalize(frame_.screen.direction(x, y)),
                                  terms_.normal,   albedo,
                                  terms_.specular, terms_.shininess};
  core::Color sum = albedo * terms_.ambient;
  for (const scene::Light& light : terms_.lights) sum += shade::direct_light(point, light);
  return sum;
}

void FlatRun::shade(const FlatPoints& points, std::span<core::Color, FlatPoints::capacity> all) const {
  if (shade_)
    shade_(terms_, points, all);
  else
    for (std::size_t k = 0; k < points.count; ++k)
      all[k] = radiance(points.x[k], points.y[k], points.albedo[k]);
}

bool is_turned(const Frame& frame, const ScreenFace& face, double x, double y) {
  return surface_point(frame, face, x, y).turned;
}

FlatSample shade_flat(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
                      double x, double y, trace::Counts& counts, const std::optional<core::Color>& albedo) {
  auto [point, cell, turned] = surface_point(frame, face, x, y);
  if (albedo) point.albedo = *albedo;
  const scene::Face& own = frame.world.bodies[face.body].faces[face.face];
  FlatSample sample{point.albedo * frame.world.ambient,
                    (cell && !albedo && cell->is_odd() ? 2u : 0u) + (turned ? 1u : 0u)};
  for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
    const scene::Light& light = frame.world.lights[i];
    if (lights[i].dark || !shade::faces(point, light) || (!own.rounded && lies_in(frame, i, own.surface)))
      continue;
    core::Color visible{1};
    if (!lights[i].casters.empty()) {
      const trace::Visible seen =
          frame.tracer.visibility({point.position, own.surface, face.body}, i, lights[i].casters, counts);
      visible = seen.value;
      sample.signature += seen.signature;
    }
    if (visible != core::black) sample.radiance += visible * shade::direct_light(point, light);
  }
  return sample;
}

} // namespace halftone::scan
