// I. Sutherland and G. Hodgman, "Reentrant polygon clipping" (1974), in the pixel's own coordinates: the ends
// of an edge are moved there without rounding, so the error of an area is that of a few operations on numbers
// up to the edge's length, below 2^-40 (tests/scan/pieces_test.cpp compares with quadruple precision).
//
// Invariant: a piece's inside and outside tile it.

#include "pieces.h"

#include <halftone/core/rounding.h>

namespace halftone::scan {

namespace {

/// A part of a pixel with less area than the rounding of an area cannot be told from none.
constexpr double least_area = core::gamma(16);

double cross(const view::ScreenPoint& a, const view::ScreenPoint& b) { return a.x * b.y - a.y * b.x; }

view::ScreenPoint minus(const view::ScreenPoint& a, const view::ScreenPoint& b) {
  return {a.x - b.x, a.y - b.y};
}

} // namespace

Piece Pieces::whole(int x, int y) {
  x_ = x;
  y_ = y;
  points_.assign({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  return {0, 4};
}

Piece Pieces::kept(const Piece& piece, bool positive) {
  Piece part{static_cast<int>(points_.size()), 0};
  for (int i = 0; i < piece.count; ++i) {
    const int j = i + 1 < piece.count ? i + 1 : 0;
    const view::ScreenPoint a = points_[piece.first + i], b = points_[piece.first + j];
    const double height_a = heights_[i], height_b = heights_[j];
    if (positive ? height_a >= 0 : height_a <= 0) points_.push_back(a);
    if ((height_a > 0 && height_b < 0) || (height_a < 0 && height_b > 0)) {
      const double s = height_a / (height_a - height_b);
      points_.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
    }
  }
  part.count = static_cast<int>(points_.size()) - part.first;
  if (part.count >= 3 && area(part) > least_area) return part;
  points_.resize(part.first);
  return {part.first, 0};
}

Sides Pieces::cut_by(const Piece& piece) {
  bool above = false, below = false;
  for (const double height : heights_) {
    above = above || height > 0;
    below = below || height < 0;
  }
  if (!below) return {piece, {}};
  if (!above) return {{}, piece};
  Sides sides;
  sides.inside = kept(piece, true);
  if (sides.inside.count == 0) return {{}, piece};
  sides.outside = kept(piece, false);
  if (sides.outside.count == 0) return {piece, {}};
  return sides;
}

Sides Pieces::cut(const Piece& piece, const Edge& edge) {
  const view::ScreenPoint along = minus(edge.lower, edge.upper);
  const view::ScreenPoint start = minus(edge.upper, {x_ * 1.0, y_ * 1.0});
  heights_.clear();
  for (const view::ScreenPoint& p : corners(piece)) {
    const double to_left =
        cross(along, minus(p, start)); // y points down: positive on the left of the way down
    heights_.push_back(edge.inside_left ? to_left : -to_left);
  }
  return cut_by(piece);
}

Sides Pieces::cut(const Piece& piece, const view::Linear& function) {
  const double here = function.at(x_, y_);
  heights_.clear();
  for (const view::ScreenPoint& p : corners(piece))
    heights_.push_back(function.a * p.x + (function.b * p.y + here));
  return cut_by(piece);
}

double Pieces::area(const Piece& piece) const {
  const auto c = corners(piece);
  double twice = 0;
  for (int i = 1; i + 1 < piece.count; ++i) twice += cross(minus(c[i], c[0]), minus(c[i + 1], c[0]));
  return twice / 2;
}

view::ScreenPoint Pieces::centroid(const Piece& piece) const {
  const auto c = corners(piece);
  double twice = 0, x = 0, y = 0;
  for (int i = 1; i + 1 < piece.count; ++i) {
    const view::ScreenPoint a = minus(c[i], c[0]), b = minus(c[i + 1], c[0]);
    const double part = cross(a, b);
    twice += part;
    x += part * (a.x + b.x);
    y += part * (a.y + b.y);
  }
  return {x_ + c[0].x + x / (3 * twice), y_ + c[0].y + y / (3 * twice)};
}

} // namespace halftone::scan
