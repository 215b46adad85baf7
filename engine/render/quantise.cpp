#include <halftone/render/quantise.h>

#include <halftone/core/elementary.h>

#include <algorithm>
#include <cmath>

namespace halftone::render {

namespace {

/// The transfer curve of IEC 61966-2-1, from linear to encoded, both in [0, 1].
double encode_srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * core::pow(linear, 1 / 2.4) - 0.055;
}

} // namespace

std::uint8_t quantise(double radiance, const scene::Image& image) {
  const double exposed = std::clamp(radiance * image.exposure, 0.0, 1.0);
  const double encoded = image.transfer == scene::Transfer::srgb ? encode_srgb(exposed) : exposed;
  return static_cast<std::uint8_t>(std::floor(encoded * 255 + 0.5));
}

void quantise(std::span<const core::Color> radiance, const scene::Image& image, std::span<std::uint8_t> rgb) {
  for (std::size_t x = 0; x < radiance.size(); ++x)
    for (int channel = 0; channel < 3; ++channel)
      rgb[3 * x + channel] = quantise(radiance[x][channel], image);
}

} // namespace halftone::render
