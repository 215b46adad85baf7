#pragma once
// Portable float map: radiance as it is, before exposure and quantisation.

#include <halftone/core/vector.h>

#include <span>
#include <string>

namespace halftone::cli {

/// The bytes of a PFM file: header "PF", size, scale -1.0 (little-endian), then 32-bit floats, bottom row
/// first. radiance has width * height pixels, rows from the top.
std::string encode_pfm(int width, int height, std::span<const core::Color> radiance);

} // namespace halftone::cli
