#pragma once
// From radiance to what a display is sent (the scene format, section 2), before rounding.

#include <halftone/scene/scene.h>

namespace halftone::shade {

/// radiance times exposure, clamped to [0, 1], through the transfer curve, times 255.
double display_level(double radiance, const scene::Image& image);

/// The radiance that is shown at a level in [0, 255], to some roundings.
double radiance_at(double level, const scene::Image& image);

} // namespace halftone::shade
