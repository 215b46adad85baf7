#pragma once
// Default rows beside the brute-force renderer.

#include <halftone/scene/scene.h>

namespace halftone::test {

/// In levels that are not rounded, on every second pixel of every second row, the reference with 12 x 12
/// samples; huge where a radiance is not finite.
double rmse_against_reference(const scene::Scene& scene);

} // namespace halftone::test
