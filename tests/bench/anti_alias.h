#pragma once
// Sampling of a picture, for any function of an image position.

#include "levels.h"

#include <functional>

namespace halftone::bench {

/// How pixels are sampled. A pixel begins as a square with a sample at each corner; a square is quartered
/// where the corners differ by more than `contrast`, down to n x n in a pixel. Where a pixel's own corners
/// differ or those of a neighbour, it is quartered to `least` x `least` in any case: a boundary that
/// separates no corners here does so there. Both are powers of two.
struct Adaptive {
  int n = 1;
  int least = 1;
  double contrast = 4; ///< in 8-bit levels
};

using Radiance = std::function<core::Color(double x, double y)>;

/// On so many threads, by tiles.
std::vector<core::Color> sample_adaptively(const scene::Image& image, const Adaptive& settings, int threads,
                                           const Radiance& radiance);

/// n x n samples in every pixel: in the middle of their cells, or somewhere in them, at a place that depends
/// on pixel and cell alone.
std::vector<core::Color> sample_evenly(const scene::Image& image, int n, bool stratified, int threads,
                                       const Radiance& radiance);

} // namespace halftone::bench
