// Adaptive sampling by what is seen (after T. Whitted 1980, section 6, corners of a pixel; D. Mitchell 1987),
// steered by the signature of the whole ray tree and not by colour alone. Corners are shared by neighbours,
// so a pixel without a boundary costs one tree, and what is looked for on the lines between bands
// (follow.cpp). Where corners differ, the cell is divided along the boundary that they show, or quartered
// until what is in question could not change the pixel by more than the tolerance (refine.cpp); where the
// exact outline of what is seen first has cut the pixel, its pieces are fans of triangles.
//
// Invariant: the samples of a band depend on the band alone; every cell is counted once, by its area.

#include "integrate.h"

#include <halftone/core/mixed.h>
#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halftone::scan {

Integrator::Integrator(const Frame& frame, int top, const Tolerance& tolerance, std::vector<Row>& band)
    : frame_(frame),
      top_(top),
      width_(frame.world.camera.width),
      tolerance_(tolerance),
      band_(band),
      samples_(frame, top, band) {}

core::Color& Integrator::radiance_of(int pixel) { return band_[pixel / width_].radiance[pixel % width_]; }

int Integrator::lattice_sample(int source, int x, int y) {
  return samples_.at(source, {x * (1.0 / lattice), top_ + y * (1.0 / lattice)});
}

Integrator::Cell Integrator::whole_pixel(int x, int y, int source) {
  Cell cell{(y - top_) * width_ + x, source, lattice, x * lattice, (y - top_) * lattice, 0, 1, 4};
  for (int k = 0; k < 4; ++k)
    cell.corners[k] = lattice_sample(source, cell.x + (k & 1) * lattice, cell.y + (k >> 1) * lattice);
  return cell;
}

ScreenPiece Integrator::screen_piece(const Pieces& pieces, const Piece& piece, int source) {
  const int first = static_cast<int>(corners_.size());
  for (int k = 0; k < piece.count; ++k) corners_.push_back(pieces.corner(piece, k));
  return {first, piece.count, pieces.centroid(piece), pieces.area(piece), source};
}

void Integrator::add_pixel(int x, int y, int source) { cells_.push_back(whole_pixel(x, y, source)); }

void Integrator::add_piece(int x, int y, const ScreenPiece& piece) {
  const auto& [first, count, centroid, area, source] = piece;
  const int pixel = (y - top_) * width_ + x;
  const int middle = samples_.at(source, centroid);
  if (area < tolerance_.piece) {
    cells_.push_back({pixel, source, 0, 0, 0, most_halvings, area, 1, {middle}});
    return;
  }
  const auto moved = [&, &from = piece.centroid](const view::ScreenPoint& p) {
    return samples_.at(
        piece.source, {p.x + core::corner_inset * (from.x - p.x), p.y + core::corner_inset * (from.y - p.y)});
  };
  for (int k = 0; k < count; ++k) {
    const view::ScreenPoint &a = corners_[first + k], &b = corners_[first + (k + 1) % count];
    const double part =
        ((a.x - centroid.x) * (b.y - centroid.y) - (a.y - centroid.y) * (b.x - centroid.x)) / 2;
    if (part != 0)
      cells_.push_back({pixel, source, 0, 0, 0, 0, std::abs(part), 3, {middle, moved(a), moved(b)}});
  }
}

void Integrator::add_cut_pixel(int x, int y, std::span<const ScreenPiece> pieces, int source) {
  // A piece at a corner of the pixel is known from there.
  const auto is_corner = [&](const view::ScreenPoint& p) {
    return (p.x == x || p.x == x + 1) && (p.y == y || p.y == y + 1);
  };
  const Cell whole = whole_pixel(x, y, source);
  for (const ScreenPiece& piece : pieces) {
    cut_pieces_.push_back(piece);
    const auto first = corners_.begin() + piece.first;
    if (std::none_of(first, first + piece.count, is_corner))
      centroids_.push_back(samples_.at(piece.source, piece.centroid));
  }
  cut_pixels_.push_back({whole, cut_pieces_.size(), centroids_.size()});
}

/// What is seen first may be the same in all pieces, and what lies behind it too: then it is a pixel like
/// others.
void Integrator::settle_cut_pixels() {
  std::size_t piece = 0, centroid = 0;
  for (const CutPixel& cut : cut_pixels_) {
    const std::uint64_t first = samples_[cut.whole.corners[0]].signature;
    bool is_whole = sees_one_thing(cut.whole);
    for (; centroid < cut.centroids_end; ++centroid)
      is_whole = is_whole && samples_[centroids_[centroid]].signature == first;
    if (is_whole) cells_.push_back(cut.whole);
    for (; piece < cut.pieces_end; ++piece)
      if (!is_whole) add_piece(cut.whole.pixel % width_, top_ + cut.whole.pixel / width_, cut_pieces_[piece]);
  }
}

core::Color Integrator::mean(const Cell& cell) const {
  core::Color sum{0};
  for (int k = 0; k < cell.count; ++k) sum += samples_[cell.corners[k]].radiance;
  // With its middle, exact for cubic functions over a square, for quadratic ones over a triangle.
  if (cell.middle >= 0) return (sum + samples_[cell.middle].radiance * (12.0 - cell.count)) / 12.0;
  return sum / static_cast<double>(cell.count);
}

/// The pixels' radiance as far as it is known after the first samples, and those in which there are pieces.
void Integrator::look_at_pixels() {
  const std::size_t pixels = band_.size() * width_;
  estimate_.reserve(pixels);
  for (const Row& row : band_) estimate_.insert(estimate_.end(), row.radiance.begin(), row.radiance.end());
  for (const Cell& cell : cells_) estimate_[cell.pixel] += cell.area * mean(cell);
  lowest_ = highest_ = estimate_;
  busy_.resize(pixels);
  guarded_.resize(pixels);
  resting_.resize(pixels, -1);
  for (const Cell& cell : cells_)
    if (cell.side == 0) busy_[cell.pixel] = 1;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    if (busy_[pixel]) guard_around(static_cast<int>(pixel));
}

/// What the pixel would change by, in levels, if the area had one radiance instead of the other.
double Integrator::levels(int pixel, double area, const core::Color& low, const core::Color& high) const {
  double most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double change = area * (high[channel] - low[channel]) / 2;
    if (change == 0) continue;
    const double at = estimate_[pixel][channel];
    most = std::max(most, frame_.level(at + change) - frame_.level(at - change));
  }
  return most;
}

void Integrator::finish(Counts& counts, const std::stop_token& stop) {
  if (cells_.empty() && cut_pixels_.empty()) return;
  samples_.evaluate(counts);
  settle_cut_pixels();
  send_scouts();
  samples_.evaluate(counts);
  look_at_pixels();
  for (const Cell& cell : cells_) {
    PixelNote& note = band_[cell.pixel / width_].notes[cell.pixel % width_];
    note.traced = note.traced || !samples_.source(cell.source).bodies.empty();
    note.signature += core::mixed(samples_[cell.corners[0]].signature +
                                  static_cast<std::uint64_t>(samples_.source(cell.source).face + 2));
  }
  hear_scouts();
  while (!stop.stop_requested() && (!cells_.empty() || !probed_.empty())) {
    look_around();
    next_.clear();
    for (Cell& cell : cells_) {
      if (cell.division >= 0) {
        advance(cell);
        continue;
      }
      switch (judge(cell)) {
      case Verdict::accept:
        radiance_of(cell.pixel) += cell.area * mean(cell);
        break;
      case Verdict::rest:
        rest(cell);
        break;
      case Verdict::look:
        look(cell);
        next_.push_back(cell);
        break;
      case Verdict::divide:
        divide(cell);
        break;
      case Verdict::split:
        split(cell);
        break;
      }
    }
    samples_.evaluate(counts);
    std::swap(cells_, next_);
  }
  for (std::size_t pixel = 0; pixel < resting_.size(); ++pixel) {
    if (resting_[pixel] < 0) continue;
    const Cell& cell = resting_cells_[resting_[pixel]].cell;
    radiance_of(cell.pixel) += cell.area * mean(cell);
  }
}

} // namespace halftone::scan
