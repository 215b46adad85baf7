#pragma once
// The mean radiance of what has to be sampled, pixel by pixel: ray trees, and faces under shadows whose
// inside has to be tested.

#include "flat_shading.h"

#include <halftone/scan/scanner.h>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace halftone::scan {

/// What is sampled: ray trees where bodies are given, otherwise the face with the shadow tests that it needs.
struct Source {
  std::vector<int> bodies; ///< that an eye ray may hit first, ascending
  int face = -1;           ///< index into Frame::faces
  std::vector<Lighting> lights;
};

/// How far to refine: differences in 8-bit levels by which a cell could change its pixel. For a whole pixel;
/// errors of many cells add by their squares, so a cell of area a is allowed sqrt(a) of it.
struct Tolerance {
  double smooth = 0; ///< between corners that see the same: below it, their mean stands for all
  double curved = 0; ///< between their mean and the middle
  double edge = 0;   ///< between corners that see different things
};

/// Of one band of rows, [top, top + rows). Positions are on the screen.
class Integrator {
public:
  /// The frame must outlive this. band: one pixel after the other, row by row; radiance is added to it.
  Integrator(const Frame& frame, int top, int rows, const Tolerance& tolerance, std::vector<Row>& band);

  /// A number for the source, for the calls below.
  int add_source(Source source);

  void add_pixel(int x, int y, int source);

  /// corners: of a convex piece of the pixel.
  void add_piece(int x, int y, std::span<const view::ScreenPoint> corners, const view::ScreenPoint& centroid,
                 double area, int source);

  /// Samples, refines, and adds the means of all that was added to the band.
  void finish(Counts& counts);

private:
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
  };

  enum class Verdict {
    accept,
    rest, ///< accept, unless a neighbour turns out to have a boundary
    look, ///< at the middle
    split,
  };

  int sample_at(int source, double x, double y);
  int lattice_sample(int source, int x, int y);
  core::Color& radiance_of(int pixel);
  void evaluate(Counts& counts);
  void estimate_pixels();
  double levels(int pixel, double area, const core::Color& low, const core::Color& high) const;
  Verdict judge(const Cell& cell) const;
  void split(const Cell& cell);
  bool sees_one_thing(const Cell& cell) const;
  void guard_around(int pixel);
  void look_around();
  void look(Cell& cell);
  core::Color mean(const Cell& cell) const;

  struct Sample {
    double x = 0, y = 0;
    int source = 0;
    core::Color radiance{0};
    std::uint64_t signature = 0;
    int rays = 0;
  };

  const Frame& frame_;
  int top_;
  int width_;
  Tolerance tolerance_;
  std::vector<Row>& band_;
  std::vector<Source> sources_;
  std::vector<Sample> samples_;
  std::size_t evaluated_ = 0;
  std::unordered_map<std::uint64_t, int> on_lattice_;
  std::unordered_map<std::uint64_t, int> between_; ///< other positions, by their bits and source, mixed
  std::vector<Cell> cells_, next_;
  std::vector<core::Color> estimate_;         ///< of each pixel, from the first samples
  std::vector<core::Color> lowest_, highest_; ///< of each pixel, of all samples so far
  std::vector<std::uint8_t> busy_;            ///< pixels with more than one thing in them
  std::vector<std::uint8_t> guarded_;         ///< their neighbours
  std::vector<int> resting_;                  ///< of each pixel, its cell among those that rest, or -1
  std::vector<Cell> resting_cells_;
  std::vector<Cell> woken_;
};

} // namespace halftone::scan
