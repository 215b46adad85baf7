#pragma once
// The reflected and the refracted rays of a slice.

#include "local.h"

namespace halftone::trace {

/// Adds to `next` the branches that are to be followed. Marks total reflections in local.facts.
void branch(const Prepared& prepared, const InsideSets& sets, const Rays& rays, Slice slice, const Seen& seen,
            Local& local, Rays& next, std::span<Sample> samples, Counts& counts);

} // namespace halftone::trace
