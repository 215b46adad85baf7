#pragma once
// What is made of a world once, before the first ray.

#include "casters.h"
#include "media.h"

#include <halftone/core/exponential.h>
#include <halftone/geometry/balls.h>
#include <halftone/geometry/bounds_tree.h>
#include <halftone/geometry/packet.h>
#include <halftone/geometry/solids.h>
#include <halftone/trace/trace.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace halftone::trace {

struct PlacedLight {
  scene::Light light;
  std::vector<int> around;   ///< the solids that contain it, ascending
  std::vector<int> in_plane; ///< the polygons in whose planes it lies, ascending: they cannot shadow anything
  std::vector<int> planes;   ///< in which it lies, ascending, as indices into World::surfaces
  Casters casters;

  bool lies_in(int surface) const { return std::binary_search(planes.begin(), planes.end(), surface); }
};

struct Prepared {
  Prepared(const scene::World& drawn, Search search, core::Simd simd);

  const scene::Material& material_of(int body) const { return world.materials[world.bodies[body].material]; }
  bool is_polygon(int body) const { return world.bodies[body].kind == scene::BodyKind::polygon; }

  /// Of a medium, along a way: shade::transmittance(), to the bit.
  core::Color transmittance(int medium, double length) const {
    const core::Color& absorption = media[medium].absorption;
    return absorption == core::black ? core::Color{1} : exp(-absorption * length);
  }

  /// Bytes, without those of the world.
  std::size_t memory() const;

  const scene::World& world;
  geometry::Solids solids;
  geometry::Balls balls;
  std::optional<geometry::BoundsTree> tree; ///< of all bodies, where a hierarchy is searched
  std::optional<geometry::Packets> packets; ///< where rays are traced side by side
  std::vector<int> all_bodies;              ///< that packets ask where there is no hierarchy
  core::ExpOfThree exp;
  Media media;
  std::vector<PlacedLight> lights;
  std::vector<int> around_eye; ///< the solids that contain the eye, ascending
  int eye_surface = -1;        ///< that the eye is on, or -1
  bool eye_in_plane = false;   ///< of any face: packets know nothing of that
};

} // namespace halftone::trace
