// Adaptive sampling by what is seen (after T. Whitted 1980, section 6, corners of a pixel; D. Mitchell 1987),
// steered by the signature of the whole ray tree and not by colour alone. Corners are shared by neighbours,
// so a pixel without a boundary costs one tree. Where corners differ, the cell is quartered until what is in
// question could not change the pixel by more than the tolerance; where the exact outline of what is seen
// first has cut the pixel, its pieces are fans of triangles, which are halved.
//
// Invariant: the samples of a band depend on the band alone; every cell is counted once, by its area.

#include "integrate.h"

#include <halftone/core/mixed.h>
#include <halftone/shade/display.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace halftone::scan {

namespace {

constexpr int lattice = 64;   ///< positions a pixel side
constexpr int least_side = 2; ///< of a square, in lattice steps
constexpr int most_halvings = 10;
/// A piece with less area has one sample.
constexpr double small_piece = 1.0 / 256;
/// Corners of a piece are moved towards its middle by this share of the way, off the edge that they lie on.
constexpr double inset = 0x1p-8;
/// A cell of so much area, whose corners say that nothing is in it or between them, is not taken at its word.
constexpr double least_looked_at = 1.0 / 16;
/// Of the contrast in a pixel, that a cell whose corners see different things is expected to hide.
constexpr double hidden_share = 0.5;

} // namespace

Integrator::Integrator(const Frame& frame, int top, int rows, const Tolerance& tolerance,
                       std::vector<Row>& band)
    : frame_(frame),
      top_(top),
      width_(frame.world.camera.width),
      tolerance_(tolerance),
      band_(band),
      estimate_(static_cast<std::size_t>(rows) * width_),
      busy_(estimate_.size()),
      guarded_(estimate_.size()),
      resting_(estimate_.size(), -1) {}

int Integrator::add_source(Source source) {
  sources_.push_back(std::move(source));
  return static_cast<int>(sources_.size()) - 1;
}

core::Color& Integrator::radiance_of(int pixel) { return band_[pixel / width_].radiance[pixel % width_]; }

int Integrator::sample_at(int source, double x, double y) {
  const std::uint64_t key = core::mixed(
      core::mixed(core::mixed(std::bit_cast<std::uint64_t>(x)) ^ std::bit_cast<std::uint64_t>(y)) +
      static_cast<std::uint64_t>(source));
  const auto [known, is_new] = between_.try_emplace(key, static_cast<int>(samples_.size()));
  if (is_new) samples_.push_back({x, y, source});
  return known->second;
}

int Integrator::lattice_sample(int source, int x, int y) {
  // Ray trees do not depend on which complete list of bodies they are given.
  const int kind = sources_[source].bodies.empty() ? source + 1 : 0;
  const std::uint64_t key = static_cast<std::uint64_t>(kind) << 32 | static_cast<std::uint64_t>(y) << 16 |
                            static_cast<std::uint64_t>(x);
  const auto [known, is_new] = on_lattice_.try_emplace(key, static_cast<int>(samples_.size()));
  if (is_new) samples_.push_back({x * (1.0 / lattice), top_ + y * (1.0 / lattice), source});
  return known->second;
}

void Integrator::add_pixel(int x, int y, int source) {
  Cell cell{(y - top_) * width_ + x, source, lattice, x * lattice, (y - top_) * lattice, 0, 1, 4};
  for (int k = 0; k < 4; ++k)
    cell.corners[k] = lattice_sample(source, cell.x + (k & 1) * lattice, cell.y + (k >> 1) * lattice);
  cells_.push_back(cell);
}

void Integrator::add_piece(int x, int y, std::span<const view::ScreenPoint> corners,
                           const view::ScreenPoint& centroid, double area, int source) {
  const int pixel = (y - top_) * width_ + x;
  busy_[pixel] = 1;
  const int middle = sample_at(source, centroid.x, centroid.y);
  if (area < small_piece) {
    cells_.push_back({pixel, source, 0, 0, 0, most_halvings, area, 1, {middle}});
    return;
  }
  const auto moved = [&](const view::ScreenPoint& p) {
    return sample_at(source, p.x + inset * (centroid.x - p.x), p.y + inset * (centroid.y - p.y));
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const view::ScreenPoint &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double part =
        ((a.x - centroid.x) * (b.y - centroid.y) - (a.y - centroid.y) * (b.x - centroid.x)) / 2;
    cells_.push_back({pixel, source, 0, 0, 0, 0, std::abs(part), 3, {middle, moved(a), moved(b)}});
  }
}

void Integrator::evaluate(Counts& counts) {
  std::vector<trace::EyeRay> rays;
  std::vector<std::size_t> of;
  for (std::size_t i = evaluated_; i < samples_.size(); ++i) {
    Sample& sample = samples_[i];
    const Source& source = sources_[sample.source];
    if (!source.bodies.empty()) {
      rays.push_back({glm::normalize(frame_.screen.direction(sample.x, sample.y)), source.bodies});
      of.push_back(i);
      continue;
    }
    const std::uint64_t before = counts.rays.shadow;
    const FlatSample flat =
        shade_flat(frame_, frame_.faces[source.face], source.lights, sample.x, sample.y, counts.rays);
    sample.radiance = flat.radiance;
    sample.signature = flat.signature;
    sample.rays = static_cast<int>(counts.rays.shadow - before);
  }
  std::vector<trace::Sample> traced(rays.size());
  frame_.tracer.trace(rays, traced, counts.rays);
  for (std::size_t k = 0; k < of.size(); ++k) {
    samples_[of[k]].radiance = traced[k].radiance;
    samples_[of[k]].signature = traced[k].tree;
    samples_[of[k]].rays = traced[k].rays;
  }
  counts.samples += samples_.size() - evaluated_;
  for (std::size_t i = evaluated_; i < samples_.size(); ++i) {
    const int x = std::clamp(static_cast<int>(samples_[i].x), 0, width_ - 1);
    const int y = std::clamp(static_cast<int>(samples_[i].y) - top_, 0, static_cast<int>(band_.size()) - 1);
    PixelNote& note = band_[y].notes[x];
    ++note.samples;
    note.rays += samples_[i].rays;
  }
  evaluated_ = samples_.size();
}

core::Color Integrator::mean(const Cell& cell) const {
  core::Color sum{0};
  for (int k = 0; k < cell.count; ++k) sum += samples_[cell.corners[k]].radiance;
  // With its middle, exact for cubic functions over a square, for quadratic ones over a triangle.
  if (cell.middle >= 0) return (sum + samples_[cell.middle].radiance * (12.0 - cell.count)) / 12.0;
  return sum / static_cast<double>(cell.count);
}

/// The pixels' radiance as far as it is known after the first samples.
void Integrator::estimate_pixels() {
  for (std::size_t pixel = 0; pixel < estimate_.size(); ++pixel)
    estimate_[pixel] = radiance_of(static_cast<int>(pixel));
  for (const Cell& cell : cells_) estimate_[cell.pixel] += cell.area * mean(cell);
}

/// What the pixel would change by, in levels, if the area had one radiance instead of the other.
double Integrator::levels(int pixel, double area, const core::Color& low, const core::Color& high) const {
  double most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double change = area * (high[channel] - low[channel]) / 2;
    if (change == 0) continue;
    const double at = estimate_[pixel][channel];
    most = std::max(most, shade::display_level(at + change, frame_.world.image) -
                              shade::display_level(at - change, frame_.world.image));
  }
  return most;
}

Integrator::Verdict Integrator::judge(const Cell& cell) const {
  if (cell.count == 1) return Verdict::accept;
  core::Color low = samples_[cell.corners[0]].radiance, high = low;
  bool same = true;
  const auto include = [&](int index) {
    low = glm::min(low, samples_[index].radiance);
    high = glm::max(high, samples_[index].radiance);
    same = same && samples_[index].signature == samples_[cell.corners[0]].signature;
  };
  for (int k = 1; k < cell.count; ++k) include(cell.corners[k]);
  const bool can_split = cell.side > 0 ? cell.side > least_side : cell.halvings < most_halvings;
  const bool can_look = cell.middle < 0;
  if (cell.middle >= 0) include(cell.middle);
  const double range = levels(cell.pixel, cell.area, low, high) / std::sqrt(cell.area);
  if (!same) {
    // Equal colours must not hide what lies between: it may differ as much as anything in the pixel.
    const double hidden =
        levels(cell.pixel, cell.area, lowest_[cell.pixel], highest_[cell.pixel]) / std::sqrt(cell.area);
    if (std::max(range, hidden_share * hidden) > tolerance_.edge)
      return can_split ? Verdict::split : Verdict::accept;
    if (can_look && cell.area >= least_looked_at) return Verdict::look;
    return cell.area > 4 * least_looked_at ? Verdict::split : Verdict::accept;
  }
  if (range <= tolerance_.smooth) {
    if (cell.side == lattice) return guarded_[cell.pixel] ? Verdict::split : Verdict::rest;
    return can_look && cell.area >= least_looked_at ? Verdict::look : Verdict::accept;
  }
  if (can_look) return Verdict::look;
  core::Color sum{0};
  for (int k = 0; k < cell.count; ++k) sum += samples_[cell.corners[k]].radiance;
  const core::Color corners = sum / static_cast<double>(cell.count), middle = samples_[cell.middle].radiance;
  const double off = levels(cell.pixel, cell.area, glm::min(corners, middle), glm::max(corners, middle));
  const bool curved = off > tolerance_.curved * std::sqrt(cell.area);
  return curved && can_split ? Verdict::split : Verdict::accept;
}

void Integrator::look(Cell& cell) {
  if (cell.side > 0) {
    cell.middle = lattice_sample(cell.source, cell.x + cell.side / 2, cell.y + cell.side / 2);
    return;
  }
  const Sample &a = samples_[cell.corners[0]], &b = samples_[cell.corners[1]], &c = samples_[cell.corners[2]];
  cell.middle = sample_at(cell.source, (a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3);
}

void Integrator::split(const Cell& cell) {
  if (cell.side > 0) {
    const int half = cell.side / 2;
    for (int quarter = 0; quarter < 4; ++quarter) {
      Cell part{
          cell.pixel, cell.source,   half, cell.x + (quarter & 1) * half, cell.y + (quarter >> 1) * half,
          0,          cell.area / 4, 4};
      for (int k = 0; k < 4; ++k)
        part.corners[k] = lattice_sample(cell.source, part.x + (k & 1) * half, part.y + (k >> 1) * half);
      next_.push_back(part);
    }
    return;
  }
  const auto distance = [&](int a, int b) {
    return std::hypot(samples_[a].x - samples_[b].x, samples_[a].y - samples_[b].y);
  };
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (distance(cell.corners[k], cell.corners[(k + 1) % 3]) >
        distance(cell.corners[longest], cell.corners[(longest + 1) % 3]))
      longest = k;
  const int a = cell.corners[longest], b = cell.corners[(longest + 1) % 3],
            c = cell.corners[(longest + 2) % 3];
  const int middle =
      sample_at(cell.source, (samples_[a].x + samples_[b].x) / 2, (samples_[a].y + samples_[b].y) / 2);
  Cell part = cell;
  ++part.halvings;
  part.area /= 2;
  part.middle = -1;
  part.corners = {c, a, middle};
  next_.push_back(part);
  part.corners = {c, middle, b};
  next_.push_back(part);
}

bool Integrator::sees_one_thing(const Cell& cell) const {
  const std::uint64_t first = samples_[cell.corners[0]].signature;
  for (int k = 1; k < cell.count; ++k)
    if (samples_[cell.corners[k]].signature != first) return false;
  return cell.middle < 0 || samples_[cell.middle].signature == first;
}

/// A thin thing that was found in a pixel may go on in its neighbours between their corners.
void Integrator::guard_around(int pixel) {
  const int x = pixel % width_, y = pixel / width_, rows = static_cast<int>(band_.size());
  for (int v = std::max(0, y - 1); v <= std::min(rows - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
      const int neighbour = v * width_ + u;
      guarded_[neighbour] = 1;
      if (resting_[neighbour] < 0) continue;
      woken_.push_back(resting_cells_[resting_[neighbour]]);
      resting_[neighbour] = -1;
    }
  }
}

/// What is known from the corners of all cells that are being worked at.
void Integrator::look_around() {
  woken_.clear();
  for (const Cell& cell : cells_) {
    for (int k = 0; k < cell.count; ++k) {
      const core::Color& radiance = samples_[cell.corners[k]].radiance;
      lowest_[cell.pixel] = glm::min(lowest_[cell.pixel], radiance);
      highest_[cell.pixel] = glm::max(highest_[cell.pixel], radiance);
    }
    if (busy_[cell.pixel] || sees_one_thing(cell)) continue;
    busy_[cell.pixel] = 1;
    guard_around(cell.pixel);
  }
  cells_.insert(cells_.end(), woken_.begin(), woken_.end());
}

void Integrator::finish(Counts& counts) {
  evaluate(counts);
  estimate_pixels();
  lowest_ = highest_ = estimate_;
  for (std::size_t pixel = 0; pixel < busy_.size(); ++pixel)
    if (busy_[pixel]) guard_around(static_cast<int>(pixel));
  for (const Cell& cell : cells_) {
    PixelNote& note = band_[cell.pixel / width_].notes[cell.pixel % width_];
    note.traced = note.traced || !sources_[cell.source].bodies.empty();
    note.signature += core::mixed(samples_[cell.corners[0]].signature +
                                  static_cast<std::uint64_t>(sources_[cell.source].face + 2));
  }
  while (!cells_.empty()) {
    look_around();
    next_.clear();
    for (Cell& cell : cells_) {
      switch (judge(cell)) {
      case Verdict::accept:
        radiance_of(cell.pixel) += cell.area * mean(cell);
        break;
      case Verdict::rest:
        resting_[cell.pixel] = static_cast<int>(resting_cells_.size());
        resting_cells_.push_back(cell);
        break;
      case Verdict::look:
        look(cell);
        next_.push_back(cell);
        break;
      case Verdict::split:
        split(cell);
        break;
      }
    }
    evaluate(counts);
    std::swap(cells_, next_);
  }
  for (std::size_t pixel = 0; pixel < resting_.size(); ++pixel) {
    if (resting_[pixel] < 0) continue;
    const Cell& cell = resting_cells_[resting_[pixel]];
    radiance_of(cell.pixel) += cell.area * mean(cell);
  }
}

} // namespace halftone::scan
