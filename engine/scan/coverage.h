#pragma once
// What is seen where in a row of pixels, exactly.

#include "body_sets.h"
#include "pieces.h"

#include <halftone/order/order.h>
#include <halftone/scan/frame.h>

namespace halftone::scan {

/// What an eye ray meets first.
struct InFront {
  int face = -1;  ///< index into Frame::faces of the nearest face drawn by scanlines, or -1: background
  int traced = 0; ///< a set of BodySets: bodies to be traced that may hide it
};

/// A convex piece of a pixel in which one thing is seen.
struct Part {
  Piece piece;
  InFront seen;
};

/// Receives the parts of a row, which tile it.
class CoverageSink {
public:
  virtual ~CoverageSink() = default;

  /// Whole pixels.
  virtual void add_pixels(PixelRange pixels, const InFront& seen) = 0;

  /// All parts of pixel x. `pieces` may be cut further during the call.
  virtual void add_parts(int x, std::span<const Part> parts, Pieces& pieces) = 0;
};

/// Keeps its memory from row to row.
class Coverage {
public:
  /// All must outlive this.
  Coverage(const Frame& frame, order::Order& order, BodySets& sets)
      : frame_(frame),
        order_(order),
        sets_(sets) {}

  void cover(int y, CoverageSink& sink);

  std::uint64_t comparisons = 0; ///< of a row or a part of a pixel with a shape, so far

private:
  /// A face or a traced shape in this row.
  struct Shape {
    int face = -1;   ///< index into Frame::faces, or -1
    int traced = -1; ///< index into Frame::traced_shapes, or -1
    RowOutline row;
  };

  const Outline& outline_of(const Shape& shape) const;
  void collect(int y);
  void cover_run(PixelRange run, int y, CoverageSink& sink);
  void cover_pixel(int x, int y, CoverageSink& sink);
  void insert_face(const Shape& shape, int x, int y);
  void insert_traced(const Shape& shape, int x);
  Piece clipped(const Shape& shape, const Piece& piece, int x, const InFront& rest);
  order::Front compare(int face, int other, std::span<const view::ScreenPoint> corners, double x, double y);
  bool is_hidden(const Shape& shape, int nearest, std::span<const view::ScreenPoint> rectangle);

  const Frame& frame_;
  order::Order& order_;
  BodySets& sets_;
  std::vector<Shape> shapes_;
  std::vector<int> open_;  ///< shapes that touch the run, as indices
  std::vector<int> front_; ///< those of them that matter in it
  Pieces pieces_;
  std::vector<Part> parts_;
};

} // namespace halftone::scan
