#pragma once
// Where the light on a face changes too much within a piece for one sample.

#include "pieces.h"
#include "stretches.h"

#include <halftone/scan/frame.h>

namespace halftone::scan {

/// Whether the middle of the piece may miss the mean over it by more than `missed` over the square root of
/// its area, in shares of the radiance that is shown as 1.
bool varies(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
            const Piece& piece, const Pieces& pieces, double missed);

/// What may_vary() is asked of.
enum class Within {
  pixels, ///< as a whole
  pieces, ///< of them, whichever
};

/// False only where varies() is false, up to rounding, for every pixel of a run in row y, or for every piece
/// of one, by bounds over the run as a whole. Not for a stand-in's round side.
bool may_vary(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights, PixelRange run,
              int y, double missed, Within within);

} // namespace halftone::scan
