#pragma once
// A Whitted ray tracer on Embree (Apache-2.0), written as well as we can; only the benchmark links it.

#include "anti_alias.h"
#include "contender.h"

namespace halftone::bench {

/// Evenly n x n samples a pixel, without contrast.
Levels embree_evenly(const scene::Scene& scene, int n, bool stratified, int threads);

Drawn embree_adaptively(const scene::Scene& scene, const Adaptive& settings, int threads);

} // namespace halftone::bench
