// When a cell is taken at its corners' word, and what happens to it otherwise: a look at its middle, a
// division along a boundary, or quarters.

#include "integrate.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

constexpr int least_side = 2; ///< of a square, in lattice steps
/// A cell of so much area, whose corners see different things of about one colour, is not taken at their
/// word.
constexpr double least_looked_at = 1.0 / 16;
/// Widths of brackets, as shares of a side.
constexpr double least_bracket = 1.0 / 64, most_bracket = 1.0 / 4;

} // namespace

Integrator::Verdict Integrator::judge(const Cell& cell) const {
  if (cell.count == 1) return Verdict::accept;
  const bool can_split = cell.side > 0 ? cell.side > least_side : cell.halvings < most_halvings;
  const bool can_look = cell.middle < 0;
  const double range = contrast(cell);
  if (!sees_one_thing(cell)) {
    // Equal colours must not hide what lies between: it may differ as much as anything in the pixel.
    const double hidden =
        levels(cell.pixel, cell.area, lowest_[cell.pixel], highest_[cell.pixel]) / std::sqrt(cell.area);
    if (std::max(range, tolerance_.hidden * hidden) > tolerance_.edge)
      return !can_split                                                             ? Verdict::accept
             : can_look && cell.side == lattice && tolerance_.looks_before_dividing ? Verdict::look
                                                                                    : Verdict::divide;
    if (can_look && cell.area >= least_looked_at) return Verdict::look;
    return cell.area > tolerance_.unseen ? Verdict::split : Verdict::accept;
  }
  // What wakes has just been probed: its middle may not be known yet.
  if (cell.side == lattice && busy_[cell.pixel]) return Verdict::split;
  if (range <= tolerance_.smooth) {
    if (cell.side == lattice) return Verdict::rest;
    return can_look && cell.area >= tolerance_.plain ? Verdict::look : Verdict::accept;
  }
  if (can_look) return Verdict::look;
  core::Color sum{0};
  for (int k = 0; k < cell.count; ++k) sum += samples_[cell.corners[k]].radiance;
  const core::Color corners = sum / static_cast<double>(cell.count), middle = samples_[cell.middle].radiance;
  const double off = levels(cell.pixel, cell.area, glm::min(corners, middle), glm::max(corners, middle));
  const bool curved = off > tolerance_.curved * std::sqrt(cell.area);
  if (curved && can_split) return Verdict::split;
  return cell.side == lattice ? Verdict::rest : Verdict::accept;
}

void Integrator::look(Cell& cell) {
  if (cell.side > 0) {
    cell.middle = lattice_sample(cell.source, cell.x + cell.side / 2, cell.y + cell.side / 2);
    return;
  }
  const auto& [a, b, c, unused] = cell.corners;
  const view::ScreenPoint p = samples_[a].at, q = samples_[b].at, r = samples_[c].at;
  cell.middle = samples_.at(cell.source, {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3});
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
    const view::ScreenPoint &p = samples_[a].at, &q = samples_[b].at;
    return std::hypot(p.x - q.x, p.y - q.y);
  };
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (distance(cell.corners[k], cell.corners[(k + 1) % 3]) >
        distance(cell.corners[longest], cell.corners[(longest + 1) % 3]))
      longest = k;
  const int a = cell.corners[longest], b = cell.corners[(longest + 1) % 3],
            c = cell.corners[(longest + 2) % 3];
  const view::ScreenPoint &p = samples_[a].at, &q = samples_[b].at;
  const int middle = samples_.at(cell.source, {(p.x + q.x) / 2, (p.y + q.y) / 2});
  Cell part = cell;
  ++part.halvings;
  part.area /= 2;
  part.middle = part.division = -1;
  part.corners = {c, a, middle};
  next_.push_back(part);
  part.corners = {c, middle, b};
  next_.push_back(part);
}

/// Of all that is known of the cell, in levels.
double Integrator::contrast(const Cell& cell) const {
  core::Color low = samples_[cell.corners[0]].radiance, high = low;
  const auto include = [&](int sample) {
    low = glm::min(low, samples_[sample].radiance);
    high = glm::max(high, samples_[sample].radiance);
  };
  for (int k = 1; k < cell.count; ++k) include(cell.corners[k]);
  if (cell.middle >= 0) include(cell.middle);
  return levels(cell.pixel, cell.area, low, high) / std::sqrt(cell.area);
}

/// Along the boundary, where what its corners see is that simple; otherwise into quarters.
void Integrator::divide(Cell& cell) {
  std::array<int, 4> around = cell.corners;
  if (cell.side > 0) std::swap(around[2], around[3]);
  const double width = std::clamp(tolerance_.place / contrast(cell), least_bracket, most_bracket);
  const auto division = Division::of(samples_, cell.source,
                                     std::span(around).first(static_cast<std::size_t>(cell.count)), width);
  if (!division || (cell.middle >= 0 && !division->sees(samples_[cell.middle].signature))) {
    split(cell);
    return;
  }
  cell.division = static_cast<int>(divisions_.size());
  divisions_.push_back(*division);
  advance(cell);
}

bool Integrator::is_smooth(const Cell& cell, const Division::Part& part) const {
  const double area = cell.area * part.share;
  if (area == 0) return true;
  core::Color low = part.low, high = part.high;
  if (cell.middle >= 0 && samples_[cell.middle].signature == part.seen) {
    low = glm::min(low, samples_[cell.middle].radiance);
    high = glm::max(high, samples_[cell.middle].radiance);
  }
  return levels(cell.pixel, area, low, high) <= tolerance_.smooth * std::sqrt(area);
}

/// A step of the cell's division, if it is being divided.
void Integrator::advance(Cell& cell) {
  Division& division = divisions_[cell.division];
  switch (division.advance(samples_)) {
  case Division::Progress::samples:
    next_.push_back(cell);
    return;
  case Division::Progress::done: {
    const auto [first, second] = division.parts(samples_);
    if (is_smooth(cell, first) && is_smooth(cell, second)) {
      radiance_of(cell.pixel) += cell.area * (first.share * first.mean + second.share * second.mean);
      return;
    }
    break;
  }
  case Division::Progress::failed:
    break;
  }
  split(cell);
}

} // namespace halftone::scan
