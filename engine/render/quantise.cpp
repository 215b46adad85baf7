#include <halftone/render/quantise.h>

#include <halftone/core/rounding.h>
#include <halftone/shade/display.h>

#include <cmath>
#include <limits>

namespace halftone::render {

namespace {

/// The least radiance of a level above 0, by halving what lies between one that is below it and one that is
/// not.
double least_radiance(int level, const scene::Image& image) {
  const double about = shade::radiance_at(level - 0.5, image);
  const auto is_reached = [&](double radiance) { return quantise(radiance, image) >= level; };
  double below = about, above = about;
  for (double share = core::gamma(32); is_reached(below); share *= 2) below = about * (1 - share);
  for (double share = core::gamma(32); !is_reached(above); share *= 2) above = about * (1 + share);
  for (;;) {
    const double middle = below + (above - below) / 2;
    if (!(middle > below && middle < above)) return above;
    (is_reached(middle) ? above : below) = middle;
  }
}

} // namespace

std::uint8_t quantise(double radiance, const scene::Image& image) {
  return static_cast<std::uint8_t>(std::floor(shade::display_level(radiance, image) + 0.5));
}

Quantiser::Quantiser(const scene::Image& image) : level_of_black_(quantise(0, image)) {
  const double white = 1 / image.exposure;               // is shown as 1, as is all beyond it
  least_.fill(std::numeric_limits<double>::quiet_NaN()); // nothing is at least that
  least_[0] = 0;
  for (int level = 1; level < 256; ++level) least_[level] = least_radiance(level, image);
  places_per_radiance_ = places / white;
  std::size_t level = 0;
  for (std::size_t place = 0; place <= places; ++place) {
    // One place early: the product in operator() is rounded.
    const double begins = place == 0 ? 0 : static_cast<double>(place - 1) / places_per_radiance_;
    while (begins >= least_[level + 1]) ++level;
    first_[place] = static_cast<std::uint8_t>(level);
  }
}

void Quantiser::operator()(std::span<const core::Color> radiance, std::span<std::uint8_t> rgb) const {
  for (std::size_t x = 0; x < radiance.size(); ++x)
    for (int channel = 0; channel < 3; ++channel) rgb[3 * x + channel] = (*this)(radiance[x][channel]);
}

} // namespace halftone::render
