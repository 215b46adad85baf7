#pragma once
// The radiance of a face drawn by scanlines at a position of the screen.

#include "flat_kernel.h"
#include "stretches.h"

#include <cstdint>
#include <optional>
#include <span>

namespace halftone::scan {

struct FlatSample {
  core::Color radiance{0};
  /// Which lights reach the point, and through what; the cell of its pattern; which way its normal was
  /// turned.
  std::uint64_t signature = 0;
};

/// lights: of the stretch that holds (x, y). Shadow tests are made against its listed casters alone, and
/// counted. albedo: in place of the face's own.
FlatSample shade_flat(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
                      double x, double y, trace::Counts& counts,
                      const std::optional<core::Color>& albedo = std::nullopt);

/// A face of which many points are shaded under the same lights, none of which needs a test: what
/// shade_flat() says of them, to the bit, without looking everything up again: but on which side of the face
/// light and eye are is decided once. Not for a stand-in's round side.
class FlatRun {
public:
  FlatRun(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
          const std::optional<core::Color>& albedo);

  struct Reflecting {
    core::Color albedo{0};
    std::uint64_t signature = 0; ///< FlatSample's
  };
  Reflecting reflecting(const view::ScreenPoint& at) const;

  /// At each of the points, side by side where the processor can do that.
  void shade(const FlatPoints& points, std::span<core::Color, FlatPoints::capacity> radiance) const;

private:
  core::Vec3 position(double x, double y) const;
  core::Color radiance(double x, double y, const core::Color& albedo) const;

  const Frame& frame_;
  const scene::Face& own_;
  const scene::Material& material_;
  std::optional<core::Color> albedo_;
  FlatTerms terms_;
  ShadeFlat shade_; ///< or nullptr
};

/// Whether the round normal of a stand-in's face looks away from the eye there, and is turned for shading.
bool is_turned(const Frame& frame, const ScreenFace& face, double x, double y);

} // namespace halftone::scan
