#pragma once
// Where the light on a face changes too much within a piece for one sample.

#include "pieces.h"
#include "stretches.h"

#include <halftone/scan/frame.h>

namespace halftone::scan {

/// Whether the middle of the piece misses the mean over it: the highlight by more than 1/768 of its peak, or
/// diffuse light by more than 1/768.
bool varies(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
            const Piece& piece, const Pieces& pieces);

} // namespace halftone::scan
