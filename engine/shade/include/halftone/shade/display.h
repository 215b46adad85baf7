#pragma once
// From radiance to what a display is sent (the scene format, section 2), before rounding.

#include <halftone/scene/scene.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace halftone::shade {

/// radiance times exposure, clamped to [0, 1], through the transfer curve, times 255.
double display_level(double radiance, const scene::Image& image);

/// The radiance that is shown at a level in [0, 255], to some roundings.
double radiance_at(double level, const scene::Image& image);

/// display_level() by straight lines between evenly spaced radiances, to judge differences by: within 0.1
/// level.
class LevelTable {
public:
  explicit LevelTable(const scene::Image& image);

  double operator()(double radiance) const {
    if (!(radiance > 0)) return levels_[0];
    const double place = std::clamp(radiance * places_per_radiance_, 0.0, 1.0 * places);
    const auto below = std::min(static_cast<std::size_t>(place), places - 1);
    return levels_[below] + (place - static_cast<double>(below)) * (levels_[below + 1] - levels_[below]);
  }

private:
  static constexpr std::size_t places = 1024;
  double places_per_radiance_ = 0;
  std::array<double, places + 1> levels_{};
};

} // namespace halftone::shade
