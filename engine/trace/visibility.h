#pragma once
// V of the scene format's section 4: how much of a light reaches a point, along the straight segment.

#include "prepared.h"
#include "rays.h"

#include <halftone/trace/trace.h>

#include <memory_resource>
#include <span>
#include <vector>

namespace halftone::trace {

/// A glass boundary between point and light. t is measured from the point; the light's own direction runs
/// against it, so the light leaves a solid at the near end of its span and enters it at the far end.
struct Boundary {
  double t = 0;
  int surface = -1;
  bool entered = false; ///< by the light on its way to the point
  Met met;
};

/// Memory for the way of a light through glass.
struct GlassScratch {
  explicit GlassScratch(std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : boundaries(memory),
        inside(memory) {}

  std::pmr::vector<Boundary> boundaries;
  std::pmr::vector<int> inside; ///< glass around the light's ray
};

/// Memory that calls in a row share.
struct ShadowScratch {
  std::vector<int> casters;
  GlassScratch glass;
  geometry::Packet packet;
  geometry::Obstacles obstacles;
  Casters::Lists near;       ///< what can stand in the way of a packet
  std::vector<int> blockers; ///< the body that last blocked each light, or -1: the first to be asked again
  std::uint64_t comparisons = 0; ///< of a ray with a body, so far
};

/// V of a light, which anything can stand in the way of.
Visible visibility(const Prepared& prepared, int light, const LitPoint& point, ShadowScratch& scratch);

/// The same for many points. result.size() == points.size().
void visibilities(const Prepared& prepared, int light, std::span<const LitPoint> points,
                  ShadowScratch& scratch, std::span<Visible> result);

/// V of a light if no body but the given ones can stand in its way.
Visible visibility(const Prepared& prepared, int light, const LitPoint& point, std::span<const int> casters,
                   GlassScratch& scratch);

/// The signature of a light that reaches a point through nothing.
std::uint64_t unshadowed(int light);

} // namespace halftone::trace
