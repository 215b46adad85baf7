#pragma once
// Local illumination of all that the rays of a slice see.

#include "seen.h"
#include "visibility.h"

#include <halftone/shade/local.h>

#include <cstdint>
#include <vector>

namespace halftone::trace {

/// One entry a ray of the slice in every array.
struct Local {
  std::vector<shade::SurfacePoint> points;
  std::vector<core::Color> radiance;
  std::vector<std::uint64_t> facts; ///< a sum of signatures: pattern, lights
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

/// Fills `local` for rays that see something, and counts shadow rays in the samples and in all.
void shade_seen(const Prepared& prepared, const Rays& rays, Slice slice, const Seen& seen,
                LocalScratch& scratch, Local& local, std::span<Sample> samples, Counts& counts);

} // namespace halftone::trace
