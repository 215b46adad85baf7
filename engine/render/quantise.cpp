#include <halftone/render/quantise.h>

#include <halftone/shade/display.h>

#include <cmath>

namespace halftone::render {

std::uint8_t quantise(double radiance, const scene::Image& image) {
  return static_cast<std::uint8_t>(std::floor(shade::display_level(radiance, image) + 0.5));
}

void quantise(std::span<const core::Color> radiance, const scene::Image& image, std::span<std::uint8_t> rgb) {
  for (std::size_t x = 0; x < radiance.size(); ++x)
    for (int channel = 0; channel < 3; ++channel)
      rgb[3 * x + channel] = quantise(radiance[x][channel], image);
}

} // namespace halftone::render
