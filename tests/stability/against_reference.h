#pragma once
// Default rows beside the brute-force renderer.

#include "tally.h"

#include <halftone/scene/scene.h>

#include <string>

namespace halftone::test {

/// One more case: a picture, on every second pixel of every second row. Its error is the RMSE in levels that
/// are not rounded; it fails from 1 on, or where a pixel is off by 16 levels or not finite. The reference has
/// 12 x 12 samples, and 96 x 96 where a pixel is off by more than 2 levels.
void add_picture(const scene::Scene& scene, const std::string& which, Tally& tally);

} // namespace halftone::test
