#pragma once
// The exact shadow of a sphere on a scanline.

#include <halftone/scan/frame.h>

#include <optional>

namespace halftone::scan {

struct SphereShadow {
  std::optional<view::Extent> extent; ///< nothing: the sphere's shadow does not meet the line
  bool dark = false;                  ///< the sphere is opaque
};

/// The shadow of `caster` within the extent that its hull's shadow has at height y; nothing where the caster
/// is not a sphere, does not stand wholly on the light's side of the face, or contains the light: then points
/// have to be tested.
std::optional<SphereShadow> exact_sphere_shadow(const Frame& frame, const ScreenFace& face, int caster,
                                                int light, double y, const view::Extent& extent);

} // namespace halftone::scan
