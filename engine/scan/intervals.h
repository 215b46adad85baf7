#pragma once
// The visible intervals of a virtual scanline.

#include <halftone/order/order.h>
#include <halftone/scan/frame.h>

#include <span>
#include <vector>

namespace halftone::scan {

/// What is seen between two positions of a scanline.
struct Interval {
  double left = 0;
  double right = 0;
  int face = -1; ///< index into Frame::faces of the nearest face drawn by scanlines, or -1: background
  std::vector<int> candidates; ///< bodies to be traced that may hide it, ascending; empty: nothing to trace
};

/// The faces and regions that a band of rows can meet, as indices into the frame.
struct Active {
  std::vector<int> faces;
  std::vector<int> traced;
};
Active active_in(const Frame& frame, double top, double bottom);

/// Intervals that cover the scanline at height y from 0 to the picture's width without gaps or overlaps, in
/// order.
std::vector<Interval> visible_intervals(const Frame& frame, const Active& active, order::Order& order,
                                        double y);

} // namespace halftone::scan
