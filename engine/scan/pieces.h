#pragma once
// Convex parts of a pixel, cut by straight lines.

#include <halftone/scan/outline.h>

#include <span>
#include <vector>

namespace halftone::scan {

/// A convex polygon: corners in Pieces. Coordinates are those of the pixel, from (0, 0) at its top left to
/// (1, 1).
struct Piece {
  int first = 0;
  int count = 0;
};

/// What is on the two sides of a line; a side without area is empty (count 0).
struct Sides {
  Piece inside;
  Piece outside;
};

class Pieces {
public:
  /// Forgets all pieces; returns the whole pixel.
  Piece whole(int x, int y);

  std::span<const view::ScreenPoint> corners(const Piece& piece) const {
    return {points_.data() + piece.first, static_cast<std::size_t>(piece.count)};
  }

  /// Inside: on the region's side of the edge.
  Sides cut(const Piece& piece, const Edge& edge);

  /// Inside: where the function of the screen is not negative.
  Sides cut(const Piece& piece, const view::Linear& function);

  double area(const Piece& piece) const;

  /// Of the area, on the screen.
  view::ScreenPoint centroid(const Piece& piece) const;

  /// On the screen.
  view::ScreenPoint corner(const Piece& piece, int k) const {
    return {x_ + points_[piece.first + k].x, y_ + points_[piece.first + k].y};
  }

private:
  Sides cut_by(const Piece& piece);
  Piece kept(const Piece& piece, bool positive);

  int x_ = 0, y_ = 0;
  std::vector<view::ScreenPoint> points_;
  std::vector<double> heights_; ///< of a piece's corners over the line that cuts it
};

} // namespace halftone::scan
