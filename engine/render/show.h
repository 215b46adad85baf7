#pragma once
// What the scan decided for each pixel, as colours (docs/show.md).

#include <halftone/render/render.h>
#include <halftone/scan/scanner.h>

#include <vector>

namespace halftone::render {

/// 3 bytes for each note.
std::vector<std::uint8_t> shown(const std::vector<scan::PixelNote>& notes, Show show, int lines);

} // namespace halftone::render
