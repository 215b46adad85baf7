#pragma once
// What scanners have counted, as statistics.

#include <halftone/render/render.h>
#include <halftone/scan/scanner.h>

namespace halftone::render {

void add(const scan::Counts& counts, Statistics& statistics);

/// What the frame has dropped before the first row, and its memory.
void add_frame(const scan::Frame& frame, Statistics& statistics);

} // namespace halftone::render
