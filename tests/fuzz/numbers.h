#pragma once
// Every number of a scene or of a surface, each of which must be finite.

#include <halftone/scene/world.h>

#include <cmath>
#include <cstdlib>

namespace halftone::fuzz {

/// Aborts at a number that is not finite, and at a normal or axis that is none.
struct Numbers {
  void operator()(double x) const {
    if (!std::isfinite(x)) std::abort();
  }
  void operator()(const core::Vec3& v) const { (*this)(v.x), (*this)(v.y), (*this)(v.z); }
  void unit(const core::Vec3& v) const {
    if (!(std::abs(glm::length(v) - 1) < 1e-12)) std::abort();
  }

  void operator()(const scene::Plane& plane) const { unit(plane.normal), (*this)(plane.offset); }
  void operator()(const scene::SphereSurface& sphere) const {
    (*this)(sphere.center), (*this)(sphere.radius);
  }
  void operator()(const scene::ConeSurface& cone) const {
    (*this)(cone.origin), unit(cone.axis), (*this)(cone.radius), (*this)(cone.slope);
  }
  void operator()(const scene::Surface& surface) const { std::visit(*this, surface); }

  void operator()(const scene::Sphere& sphere) const { (*this)(sphere.center), (*this)(sphere.radius); }
  void operator()(const scene::Frustum& frustum) const {
    (*this)(frustum.base), (*this)(frustum.top), (*this)(frustum.base_radius), (*this)(frustum.top_radius);
  }
  void operator()(const scene::Box& box) const { (*this)(box.min), (*this)(box.max); }
  void operator()(const scene::Prism& prism) const {
    (*this)(prism.base), (*this)(prism.top), (*this)(prism.radius), (*this)(prism.turn);
  }
  void operator()(const scene::Polyhedron& polyhedron) const {
    for (const core::Vec3& vertex : polyhedron.vertices) (*this)(vertex);
  }
  void operator()(const scene::Polygon& polygon) const {
    for (const core::Vec3& vertex : polygon.vertices) (*this)(vertex);
  }

  void operator()(const scene::Material& material) const {
    (*this)(material.diffuse), (*this)(material.specular), (*this)(material.shininess);
    (*this)(material.mirror), (*this)(material.opaque);
    if (material.glass) (*this)(material.glass->ior), (*this)(material.glass->absorption);
    if (material.checker) (*this)(material.checker->color), (*this)(material.checker->size);
  }
  void operator()(const scene::Scene& scene) const {
    (*this)(scene.image.exposure), (*this)(scene.background), (*this)(scene.ambient);
    (*this)(scene.camera.eye), (*this)(scene.camera.target), (*this)(scene.camera.up),
        (*this)(scene.camera.fov);
    (*this)(scene.trace.cutoff);
    for (const scene::Light& light : scene.lights) (*this)(light.position), (*this)(light.color);
    for (const scene::Material& material : scene.materials) (*this)(material);
    for (const scene::Object& object : scene.objects) {
      std::visit(*this, object.shape);
      (*this)(object.placement.scale), (*this)(object.placement.rotate), (*this)(object.placement.translate);
    }
  }
};

} // namespace halftone::fuzz
