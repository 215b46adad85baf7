#pragma once
// The reflected and the refracted rays of a slice.

#include "local.h"

namespace halftone::trace {

/// Adds to `next` the branches that are to be followed; their gaps refer to the same Mets. Marks total
/// reflections in Local::facts.
void branch(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays,
            std::span<const Seen> seen, std::span<Local> local, std::vector<Ray>& next,
            std::span<Sample> samples, Counts& counts);

} // namespace halftone::trace
