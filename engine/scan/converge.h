#pragma once
// Stretches of scanlines that are sampled at a fixed step, with convergence on the boundaries between
// samples.

#include "flat_shading.h"

#include <cstdint>
#include <span>
#include <vector>

namespace halftone::scan {

struct Sample {
  double x = 0;
  core::Color radiance{0};
  std::uint64_t signature = 0;
  int rays = 0;
};

/// What is sampled between left and right at height y: ray trees where bodies are given, otherwise the face,
/// with the shadow tests that its lighting needs.
struct Sampled {
  double left = 0;
  double right = 0;
  double y = 0;
  std::vector<int> bodies; ///< that an eye ray may hit first, ascending
  int face = -1;           ///< index into Frame::faces
  std::vector<Lighting> lights;
  std::vector<Sample> samples; ///< filled by converge(): ascending x, at least one
};

/// Samples every stretch `per_pixel` times a pixel, then halves the distance between neighbours whose
/// signatures differ until it is below 1/128 pixel. Each round is one batch over all stretches.
void converge(const Frame& frame, std::span<Sampled> stretches, int per_pixel, trace::Counts& counts);

} // namespace halftone::scan
