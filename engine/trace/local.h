#pragma once
// Local illumination of all that the rays of a slice see.

#include "seen.h"
#include "visibility.h"

#include <halftone/shade/local.h>

#include <cstdint>
#include <vector>

namespace halftone::trace {

/// Of what one ray sees.
struct Local {
  core::Color radiance{0};
  std::uint64_t facts = 0; ///< a sum of signatures: pattern, lights
  core::Vec3 normal{0};    ///< faces the ray
};

/// Shadow rays to one light.
struct ShadowRays {
  std::vector<std::size_t> of;    ///< entry of the slice
  std::vector<core::Color> light; ///< that arrives if nothing is in its way
};

struct LocalScratch {
  std::vector<LitPoint> lit; ///< by one light
  std::vector<Visible> visible;
  std::vector<ShadowRays> to_light; ///< one for each light
  ShadowScratch shadow;
};

/// Of rays that see something, and counts shadow rays in the samples and in all. local.size() == rays.size().
void shade_seen(const Prepared& prepared, std::span<const Ray> rays, std::span<const Seen> seen,
                LocalScratch& scratch, std::span<Local> local, std::span<Sample> samples, Counts& counts);

} // namespace halftone::trace
