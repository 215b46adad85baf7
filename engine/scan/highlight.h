#pragma once
// Where the highlight on a face changes too much within a piece for one sample.

#include "pieces.h"
#include "stretches.h"

#include <halftone/scan/frame.h>

namespace halftone::scan {

/// Parts along each side of the pixel, 1 to 64, so that the middle of each stands for it.
int highlight_parts(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
                    const Piece& piece, const Pieces& pieces);

} // namespace halftone::scan
