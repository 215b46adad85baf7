#include <halftone/shade/display.h>

#include <halftone/core/elementary.h>

#include <algorithm>

namespace halftone::shade {

namespace {

/// The transfer curve of IEC 61966-2-1, from linear to encoded, both in [0, 1].
double encode_srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * core::pow(linear, 1 / 2.4) - 0.055;
}

double decode_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : core::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace

double radiance_at(double level, const scene::Image& image) {
  const double shown = level / 255;
  return (image.transfer == scene::Transfer::srgb ? decode_srgb(shown) : shown) / image.exposure;
}

double display_level(double radiance, const scene::Image& image) {
  const double exposed = std::clamp(radiance * image.exposure, 0.0, 1.0);
  return 255 * (image.transfer == scene::Transfer::srgb ? encode_srgb(exposed) : exposed);
}

LevelTable::LevelTable(const scene::Image& image) : places_per_radiance_(places * image.exposure) {
  for (std::size_t place = 0; place <= places; ++place)
    levels_[place] = display_level(static_cast<double>(place) / places_per_radiance_, image);
}

} // namespace halftone::shade
