#pragma once
// The brute-force truth: every pixel, every object, no acceleration structure, written to be checked by
// reading against the scene format. Shares with the rest of the engine only the scene and the shading
// formulas.

#include <halftone/scene/world.h>

#include <cstdint>
#include <memory>

namespace halftone::reference {

struct Counts {
  std::uint64_t eye = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;
  std::uint64_t shadow = 0;
};

/// Where in each cell of a pixel's n x n grid its sample lies.
enum class Sampling {
  centred,    ///< in the middle: mode full, the conventional method
  stratified, ///< at a place that depends only on pixel and cell: mode reference
};

class Reference {
public:
  /// The world must outlive this.
  explicit Reference(const scene::World& world);
  ~Reference();

  /// Radiance of one ray through continuous image position (x, y), in pixels. Safe to call from several
  /// threads.
  core::Color radiance(double x, double y, Counts& counts) const;

  /// Mean radiance of a pixel over samples_per_side^2 samples.
  core::Color pixel(int x, int y, int samples_per_side, Sampling sampling, Counts& counts) const;

private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

} // namespace halftone::reference
