#pragma once
// From radiance to 8 bits (the scene format, section 2).

#include <halftone/scene/scene.h>

#include <array>
#include <cstdint>
#include <span>

namespace halftone::render {

/// radiance times exposure, clamped to [0, 1], through the transfer curve, times 255, half rounded up.
std::uint8_t quantise(double radiance, const scene::Image& image);

/// The same for rows of a picture, by the least radiance of each level: no power for each number. Different
/// only where the curve itself is not sure, within its own rounding of such a radiance.
class Quantiser {
public:
  explicit Quantiser(const scene::Image& image);

  std::uint8_t operator()(double radiance) const {
    if (!(radiance > 0)) return level_of_black_;
    const double place = radiance * places_per_radiance_;
    std::size_t level = place < places ? first_[static_cast<std::size_t>(place)] : first_[places];
    while (radiance >= least_[level + 1]) ++level;
    return static_cast<std::uint8_t>(level);
  }

  /// rgb has 3 bytes for each pixel of radiance.
  void operator()(std::span<const core::Color> radiance, std::span<std::uint8_t> rgb) const;

private:
  static constexpr std::size_t places = 4096; ///< of radiance up to the greatest level, evenly spaced

  std::uint8_t level_of_black_ = 0;
  double places_per_radiance_ = 0;
  std::array<double, 257> least_{};              ///< radiance of each level; of none beyond 255
  std::array<std::uint8_t, places + 1> first_{}; ///< level at the beginning of each place
};

} // namespace halftone::render
