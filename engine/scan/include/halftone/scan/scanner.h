#pragma once
// Rows of radiance by virtual scanlines: the paper's method.

#include <halftone/order/order.h>
#include <halftone/scan/frame.h>
#include <halftone/shadow/shadows.h>

#include <cstdint>
#include <vector>

namespace halftone::scan {

/// What was decided for a pixel, over all its virtual scanlines.
struct PixelNote {
  int intervals = 0; ///< visible intervals that touch it
  int samples = 0;   ///< points that were shaded
  int rays = 0;      ///< eye, reflected, refracted and shadow rays
  bool traced = false;
  std::uint64_t signature = 0; ///< a sum over what is seen in it; only of exact rows
};

struct Counts {
  trace::Counts rays;
  std::uint64_t virtual_lines = 0;
  std::uint64_t intervals = 0;
  std::uint64_t samples = 0;
  std::uint64_t traced_pixels = 0; ///< in which an eye ray was cast
  std::uint64_t plain_pixels = 0;  ///< in which at most one sample was taken; only of exact rows
  std::uint64_t comparisons = 0;   ///< of a row, a part of a pixel or a face with a shape or a shadow
};

struct Row {
  std::vector<core::Color> radiance;
  std::vector<PixelNote> notes;
};

/// Remembers the relations and shadows that it has found. One for each thread; rows have the same bits for
/// any.
class Scanner {
public:
  /// The frame must outlive this.
  explicit Scanner(const Frame& frame);

  /// Row y from `lines` virtual scanlines, evenly spaced.
  Row scan(int y, int lines);

  Counts counts; ///< of all rows so far

private:
  const Frame& frame_;
  order::Order order_;
  shadow::Shadows shadows_;
};

} // namespace halftone::scan
