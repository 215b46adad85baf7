#pragma once
// The difference of two pictures, in 8-bit levels.

#include <halftone/png/png.h>

namespace halftone::png {

struct Difference {
  double rmse = 0;   ///< over all channels
  int largest = 0;   ///< largest difference of a channel
  int largest_x = 0; ///< where it is (the first such pixel in reading order)
  int largest_y = 0;
  double percentile_999 = 0; ///< of the pixels' largest channel differences: 99.9 % are not above it
  double share_over_1 = 0;   ///< share of pixels with a channel off by more than this many levels
  double share_over_4 = 0;
  double share_over_16 = 0;
};

/// Both pictures must have the same size, and a pixel at least (std::invalid_argument).
Difference compare(const Picture& a, const Picture& b);

/// A picture of the differences: mid-grey (128) where equal, each channel's difference a - b times gain
/// around it, cut off at 0 and 255. Sizes as above.
Picture difference_picture(const Picture& a, const Picture& b, int gain = 8);

} // namespace halftone::png
