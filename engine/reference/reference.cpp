#include <halftone/reference/reference.h>

#include "tracer.h"

#include <cmath>

namespace halftone::reference {

namespace {

/// SplitMix64 (G. Steele, D. Lea, C. Flood 2014): 64 well-mixed bits of a counter.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

} // namespace

struct Reference::Impl {
  const World& world;
  std::vector<PlacedLight> lights;
  PlacedEye eye;
};

Reference::Reference(const scene::World& world) {
  Impl impl{world, {}, {solids_around(world, world.camera.eye), -1}};
  bool is_round = false; // such a surface has to be the fact: planes are met by fact anyhow
  for (int s = 0; s < static_cast<int>(world.surfaces.size()); ++s) {
    const Height height = height_over(world, world.surfaces[s], world.camera.eye);
    if (std::abs(height.value) > height.bound) continue;
    const bool is_plane = std::holds_alternative<scene::Plane>(world.surfaces[s]);
    if (impl.eye.surface >= 0 && (is_plane || is_round)) continue;
    impl.eye.surface = s;
    is_round = !is_plane;
  }
  for (const scene::Light& light : world.lights)
    impl.lights.push_back({light, solids_around(world, light.position),
                           polygons_through(world, light.position), planes_through(world, light.position)});
  impl_ = std::make_unique<const Impl>(std::move(impl));
}

Reference::~Reference() = default;

core::Color Reference::radiance(double x, double y, Counts& counts) const {
  Tracer tracer(impl_->world, impl_->lights, impl_->eye, counts);
  return tracer.eye_ray(impl_->world.camera.direction(x, y));
}

core::Color Reference::pixel(int x, int y, int samples_per_side, Sampling sampling, Counts& counts) const {
  core::Color sum{0};
  for (int j = 0; j < samples_per_side; ++j) {
    for (int i = 0; i < samples_per_side; ++i) {
      double u = 0.5, v = 0.5;
      if (sampling == Sampling::stratified) {
        // At most 2^9 x 2^9 pixels; cells beyond 2^20 a side would repeat, which no run reaches.
        const std::uint64_t cell = (static_cast<std::uint64_t>(j) << 20) | static_cast<std::uint64_t>(i);
        const std::uint64_t bits =
            mixed(mixed(static_cast<std::uint64_t>(y) * 512 + static_cast<std::uint64_t>(x)) ^ cell);
        u = static_cast<double>(bits >> 32) * 0x1p-32;
        v = static_cast<double>(bits & 0xffffffffu) * 0x1p-32;
      }
      sum += radiance(x + (i + u) / samples_per_side, y + (j + v) / samples_per_side, counts);
    }
  }
  return sum / static_cast<double>(samples_per_side * samples_per_side);
}

} // namespace halftone::reference
