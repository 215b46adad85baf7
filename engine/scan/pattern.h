#pragma once
// The lines of a pattern on the screen. Where one of a face's two cell numbers changes, depth times a
// coordinate is linear: eye + direction / (1 / depth) = value is a straight line.

#include "pieces.h"

#include <halftone/scan/frame.h>

#include <array>

namespace halftone::scan {

/// Lines of one axis that pass through a piece: those of cells in (first, last].
struct PatternLines {
  double first = 0;
  double last = 0;

  double count() const { return last - first; }
};

/// For both axes; none along an axis on which the face lies in one cell, or where it has no pattern.
std::array<PatternLines, 2> pattern_lines(const Frame& frame, const ScreenFace& face, const Piece& piece,
                                          const Pieces& pieces);

/// Whether lines pass through a part of a row.
bool has_pattern_lines(const Frame& frame, const ScreenFace& face, PixelRange run, int y);

/// Zero on the line at which cell number `cell` of the axis begins.
view::Linear pattern_line(const Frame& frame, const ScreenFace& face, int axis, double cell);

} // namespace halftone::scan
