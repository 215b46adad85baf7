#pragma once
// The mean radiance of what has to be sampled, pixel by pixel: ray trees, and faces under shadows whose
// inside has to be tested.

#include "division.h"
#include "pieces.h"
#include "samples.h"

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace halftone::scan {

/// A convex piece of a pixel, to be sampled.
struct ScreenPiece {
  int first = 0, count = 0; ///< corners, in order around it; in the integrator
  view::ScreenPoint centroid;
  double area = 0;
  int source = 0;
};

/// How far to refine: differences in 8-bit levels by which a cell could change its pixel. For a whole pixel;
/// errors of many cells add by their squares, so a cell of area a is allowed sqrt(a) of it.
struct Tolerance {
  double smooth = 0; ///< between corners that see the same: below it, their mean stands for all
  double curved = 0; ///< between their mean and the middle
  double edge = 0;   ///< between corners that see different things
  double hidden = 0; ///< of the contrast in a pixel, that a cell whose corners see different things may hide
  double place = 0;  ///< by the width of the bracket in which a boundary is found
  double piece = 0;  ///< area of a piece that has one sample
  double unseen =
      0; ///< area of a cell that is quartered though its middle shows nothing that it has to be for
  double plain = 0; ///< area of a cell below which corners that see the same, of one colour, are believed
  int scouts = 1;   ///< distances between samples on a pixel's side where thin things are looked for
  bool looks_before_dividing = true; ///< at the middle of a whole pixel
  bool probes_sides = true;          ///< of pixels beside a boundary, not only their middle
};

/// Of one band of rows, [top, top + band.size()). Positions are on the screen.
class Integrator {
public:
  /// The frame must outlive this. band: one pixel after the other, row by row; radiance is added to it.
  Integrator(const Frame& frame, int top, const Tolerance& tolerance, std::vector<Row>& band);

  /// A number for the source, for the calls below.
  int add_source(Source source) { return samples_.add_source(std::move(source)); }

  /// For the calls below.
  ScreenPiece screen_piece(const Pieces& pieces, const Piece& piece, int source);

  void add_pixel(int x, int y, int source);

  void add_piece(int x, int y, const ScreenPiece& piece);

  /// A pixel of pieces between which there may be no difference. source: good for all of them.
  void add_cut_pixel(int x, int y, std::span<const ScreenPiece> pieces, int source);

  /// Samples, refines, and adds the means of all that was added to the band; not all of them where `stop` is
  /// asked for.
  void finish(Counts& counts, const std::stop_token& stop);

private:
  static constexpr int lattice = 64;       ///< positions a pixel side
  static constexpr int most_halvings = 10; ///< of a triangle

  /// A square with four corners, or a triangle with three.
  struct Cell {
    int pixel = 0;
    int source = 0;
    int side = 0;     ///< of a square, in lattice steps; 0: a triangle
    int x = 0, y = 0; ///< of a square's top left corner, in lattice steps
    int halvings = 0; ///< of a triangle
    double area = 0;
    int count = 0;
    std::array<int, 4> corners{};
    int middle = -1;
    int division = -1; ///< in progress: index into divisions_
  };

  /// A whole pixel whose corners see the same.
  struct Resting {
    Cell cell;
    std::array<int, 4> sides{-1, -1, -1, -1}; ///< samples at their middles, once they are probed
  };

  /// A sample between the corners of a pixel's side.
  struct Scout {
    int pixel = 0;
    int sample = 0;
  };

  struct CutPixel {
    Cell whole;
    std::size_t pieces_end = 0;    ///< of its pieces in cut_pieces_
    std::size_t centroids_end = 0; ///< of its samples in centroids_
  };

  enum class Verdict {
    accept,
    rest, ///< a whole pixel: accept, unless a neighbour has a boundary that goes on in it
    look, ///< at the middle
    divide,
    split,
  };

  int lattice_sample(int source, int x, int y);
  core::Color& radiance_of(int pixel);
  Cell whole_pixel(int x, int y, int source);
  void settle_cut_pixels();
  void send_scouts();
  void hear_scouts();
  void look_at_pixels();
  double levels(int pixel, double area, const core::Color& low, const core::Color& high) const;
  Verdict judge(const Cell& cell) const;
  void split(const Cell& cell);
  void divide(Cell& cell);
  bool is_smooth(const Cell& cell, const Division::Part& part) const;
  double contrast(const Cell& cell) const;
  void advance(Cell& cell);
  bool sees_one_thing(const Cell& cell) const;
  void rest(const Cell& cell);
  void probe(int resting);
  bool is_plain(const Resting& resting) const;
  void wake(int pixel);
  void wake_across(const Cell& cell);
  void guard_around(int pixel);
  void look_around();
  void look(Cell& cell);
  core::Color mean(const Cell& cell) const;

  const Frame& frame_;
  int top_;
  int width_;
  Tolerance tolerance_;
  std::vector<Row>& band_;
  Samples samples_;
  std::vector<Division> divisions_;
  std::vector<view::ScreenPoint> corners_; ///< of screen pieces
  std::vector<CutPixel> cut_pixels_;
  std::vector<ScreenPiece> cut_pieces_; ///< of cut pixels, one after the other
  std::vector<int> centroids_;          ///< samples in those of them that no corner of the pixel is in
  std::vector<Cell> cells_, next_;
  std::vector<core::Color> estimate_;         ///< of each pixel, from the first samples
  std::vector<core::Color> lowest_, highest_; ///< of each pixel, of the estimate and the corners of its cells
  std::vector<std::uint8_t> busy_;            ///< pixels with more than one thing in them
  std::vector<std::uint8_t> guarded_;         ///< their neighbours, which are probed
  std::vector<int> resting_;                  ///< of each pixel, its cell among those that rest, or -1
  std::vector<Resting> resting_cells_;
  std::vector<int> probed_; ///< of these, in the last round
  std::vector<Scout> scouts_;
};

} // namespace halftone::scan
