// The two chains of a convex polygon (M. Shamos, D. Hoey 1976), cut by rows.
//
// Invariant: an edge is in the list of every pixel whose inside it passes through; so the part of a pixel
// that the region covers is what all edges listed for that pixel leave of it. (If another edge's line cut off
// a point of the pixel, the way from there to the region would cross the boundary inside the pixel, on a
// listed edge.)

#include <halftone/scan/outline.h>

#include <halftone/core/rounding.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halftone::scan {

namespace {

/// Least and greatest x of an edge within a row; widened by the rounding of an end that had to be computed.
view::Extent extent_within(const Edge& edge, double top, double bottom) {
  const view::ScreenPoint &a = edge.upper, &b = edge.lower;
  const auto x_at = [&](double y) { return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)); };
  const double bound = a.x == b.x ? 0 : core::gamma(5) * (std::abs(a.x) + std::abs(b.x));
  view::Extent extent{std::min(a.x, b.x), std::max(a.x, b.x)};
  const bool falls_right = a.x < b.x;
  if (a.y < top) (falls_right ? extent.left : extent.right) = x_at(top) + (falls_right ? -bound : bound);
  if (b.y > bottom)
    (falls_right ? extent.right : extent.left) = x_at(bottom) + (falls_right ? bound : -bound);
  return extent;
}

PixelRange pixels_of(const view::Extent& extent) {
  return {static_cast<int>(std::floor(extent.left)), static_cast<int>(std::ceil(extent.right))};
}

} // namespace

Outline::Outline(const view::ScreenPolygon& polygon) : top(polygon[0].y), bottom(polygon[0].y) {
  const bool clockwise = view::signed_area(polygon) > 0; // as seen, y pointing down
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const view::ScreenPoint& a = polygon[i];
    const view::ScreenPoint& b = polygon[(i + 1) % polygon.size()];
    top = std::min(top, a.y);
    bottom = std::max(bottom, a.y);
    if (a.x == b.x && a.y == b.y) continue;
    const bool forward = a.y != b.y ? a.y < b.y : a.x < b.x;
    const Edge edge{forward ? a : b, forward ? b : a, forward == clockwise};
    if (a.y == b.y)
      level_.push_back(edge);
    else
      (edge.inside_left ? right_ : left_).push_back(edge);
  }
  const auto downwards = [](const Edge& a, const Edge& b) { return a.upper.y < b.upper.y; };
  std::sort(left_.begin(), left_.end(), downwards);
  std::sort(right_.begin(), right_.end(), downwards);
}

RowOutline Outline::in_row(int y) const {
  RowOutline row;
  const double row_top = y, row_bottom = y + 1.0;
  bool any = false;
  view::Extent reach;
  const auto add = [&](const Edge& edge, int& full_end, bool right) {
    const view::Extent extent = extent_within(edge, row_top, row_bottom);
    reach =
        any ? view::Extent{std::min(reach.left, extent.left), std::max(reach.right, extent.right)} : extent;
    any = true;
    const PixelRange pixels = pixels_of(extent);
    full_end = right ? std::min(full_end, pixels.begin) : std::max(full_end, pixels.end);
    if (!pixels.is_empty()) row.edges.push_back({edge, pixels});
  };
  int full_begin = 0, full_end = 1 << 20; // beyond any picture's width
  const auto add_chain = [&](const std::vector<Edge>& chain, int& end, bool right) {
    auto edge =
        std::partition_point(chain.begin(), chain.end(), [&](const Edge& e) { return e.lower.y <= row_top; });
    for (; edge != chain.end() && edge->upper.y < row_bottom; ++edge) add(*edge, end, right);
  };
  add_chain(left_, full_begin, false);
  add_chain(right_, full_end, true);
  for (const Edge& edge : level_)
    if (edge.upper.y > row_top && edge.upper.y < row_bottom) {
      add(edge, full_begin, false);
      add(edge, full_end, true);
      row.edges.pop_back(); // it is listed once
    }
  if (!any) return row;
  std::sort(row.edges.begin(), row.edges.end(), [](const RowEdge& a, const RowEdge& b) {
    return std::pair(a.edge.upper.y, a.edge.lower.y) < std::pair(b.edge.upper.y, b.edge.lower.y);
  });
  row.touched = pixels_of(reach);
  row.full = {std::max(full_begin, row.touched.begin), std::min(full_end, row.touched.end)};
  if (row.full.is_empty()) row.full = {};
  return row;
}

std::size_t Outline::memory() const {
  return core::memory_of(left_) + core::memory_of(right_) + core::memory_of(level_);
}

geometry::Bounds row_bounds(int y) { return {{0, y, 0}, {1, y + 1, 0}}; }

geometry::Bounds row_bounds(const Outline& outline) { return {{0, outline.top, 0}, {1, outline.bottom, 0}}; }

} // namespace halftone::scan
