#pragma once
// A convex region of the screen, row by row: which pixels it touches, which it fills, and which of its edges
// pass through a pixel.

#include <halftone/geometry/bounds_tree.h>
#include <halftone/view/screen.h>

#include <vector>

namespace halftone::scan {

/// A straight edge from its upper end (the left one, if level) to its lower one, however the region is
/// walked: neighbours that share an edge have the same bits.
struct Edge {
  view::ScreenPoint upper;
  view::ScreenPoint lower;
  bool inside_left = false; ///< the region lies to the left of it (below it, if level)
};

/// Pixel columns [begin, end).
struct PixelRange {
  int begin = 0;
  int end = 0;

  bool is_empty() const { return begin >= end; }
  bool contains(int x) const { return begin <= x && x < end; }
};

/// An edge, and the pixels of a row whose inside it may pass through.
struct RowEdge {
  Edge edge;
  PixelRange pixels;
};

/// What a region is in one row.
struct RowOutline {
  PixelRange touched;         ///< pixels that it may cover a part of
  PixelRange full;            ///< pixels that it covers wholly: no edge passes through them
  std::vector<RowEdge> edges; ///< downwards: mirrored regions are cut in the same order
};

class Outline {
public:
  explicit Outline(const view::ScreenPolygon& polygon);

  /// Of the row of pixels [y, y + 1].
  RowOutline in_row(int y) const;

  /// Bytes that it holds.
  std::size_t memory() const;

  double top = 0, bottom = 0; ///< least and greatest y

private:
  std::vector<Edge> left_, right_; ///< downwards
  std::vector<Edge> level_;
};

/// A row of pixels, and the rows that a region meets, as boxes: those of regions that touch a row meet it.
geometry::Bounds row_bounds(int y);
geometry::Bounds row_bounds(const Outline& outline);

} // namespace halftone::scan
