#pragma once
// From radiance to 8 bits (the scene format, section 2).

#include <halftone/scene/scene.h>

#include <cstdint>
#include <span>

namespace halftone::render {

/// radiance times exposure, clamped to [0, 1], through the transfer curve, times 255, half rounded up.
std::uint8_t quantise(double radiance, const scene::Image& image);

/// A row; rgb has 3 bytes for each pixel of radiance.
void quantise(std::span<const core::Color> radiance, const scene::Image& image, std::span<std::uint8_t> rgb);

} // namespace halftone::render
