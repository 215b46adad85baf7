// Thin things, found and followed from pixel to pixel. They are looked for along the first and the last line
// of a band, where the bands above and below look too, and on every 32nd column from the middle: a thing that
// is wider than the distance of scouts there and crosses one of these lines is found. A pixel whose corners
// see the same rests; beside a pixel with a boundary in it, it is probed at its middle and between its
// corners; where a thing is seen on a side from one pixel, the other wakes.

#include "integrate.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <utility>

namespace halftone::scan {

namespace {

constexpr int scouted_columns = 32;

} // namespace

bool Integrator::sees_one_thing(const Cell& cell) const {
  const std::uint64_t first = samples_[cell.corners[0]].signature;
  for (int k = 1; k < cell.count; ++k)
    if (samples_[cell.corners[k]].signature != first) return false;
  return cell.middle < 0 || samples_[cell.middle].signature == first;
}

void Integrator::send_scouts() {
  const int rows = static_cast<int>(band_.size());
  for (const Cell& cell : cells_) {
    if (cell.side != lattice) continue;
    const int x = cell.pixel % width_, y = cell.pixel / width_;
    for (int k = 1; k < tolerance_.scouts; ++k) {
      const int along = k * lattice / tolerance_.scouts;
      if (y == 0) scouts_.push_back({cell.pixel, lattice_sample(cell.source, cell.x + along, cell.y)});
      if (y == rows - 1)
        scouts_.push_back({cell.pixel, lattice_sample(cell.source, cell.x + along, cell.y + lattice)});
      // As far to the left of the middle as to the right.
      if (x > 0 && std::abs(2 * x - width_) % (2 * scouted_columns) <= 1)
        scouts_.push_back({cell.pixel, lattice_sample(cell.source, cell.x, cell.y + along)});
    }
  }
}

/// Pixels in which something was found between corners that see the same are worked at like those with
/// boundaries.
void Integrator::hear_scouts() {
  std::vector<int> first(estimate_.size(), -1); // sample at a corner
  for (const Cell& cell : cells_)
    if (cell.side == lattice) first[cell.pixel] = cell.corners[0];
  const auto hear = [&](const Scout& scout, int pixel) {
    if (first[pixel] < 0 || samples_[scout.sample].signature == samples_[first[pixel]].signature) return;
    busy_[pixel] = 1;
    guard_around(pixel);
  };
  for (const Scout& scout : scouts_) {
    hear(scout, scout.pixel);
    const ScreenSample& sample = samples_[scout.sample];
    const int x = scout.pixel % width_;
    if (x > 0 && sample.at.x == x) hear(scout, scout.pixel - 1);
  }
}

void Integrator::rest(const Cell& cell) {
  resting_[cell.pixel] = static_cast<int>(resting_cells_.size());
  resting_cells_.push_back({cell});
  if (guarded_[cell.pixel]) probe(resting_[cell.pixel]);
}

void Integrator::probe(int resting) {
  auto& [cell, sides] = resting_cells_[resting];
  look(cell);
  if (tolerance_.probes_sides) {
    constexpr int half = lattice / 2;
    sides = {lattice_sample(cell.source, cell.x + half, cell.y),
             lattice_sample(cell.source, cell.x, cell.y + half),
             lattice_sample(cell.source, cell.x + lattice, cell.y + half),
             lattice_sample(cell.source, cell.x + half, cell.y + lattice)};
  }
  probed_.push_back(resting);
}

/// Whether what was probed is what the corners lead to expect.
bool Integrator::is_plain(const Resting& resting) const {
  const auto& [cell, sides] = resting;
  const std::uint64_t signature = samples_[cell.corners[0]].signature;
  const auto is_between = [&, &own = cell](int probe, std::initializer_list<int> ends) {
    if (probe < 0) return true;
    core::Color mean{0};
    for (const int end : ends) mean += samples_[own.corners[end]].radiance / static_cast<double>(ends.size());
    const auto& [at, source, radiance, seen, rays] = samples_[probe];
    return seen == signature &&
           levels(own.pixel, 1, glm::min(mean, radiance), glm::max(mean, radiance)) <= tolerance_.curved;
  };
  return is_between(cell.middle, {0, 1, 2, 3}) && is_between(sides[0], {0, 1}) &&
         is_between(sides[1], {0, 2}) && is_between(sides[2], {1, 3}) && is_between(sides[3], {2, 3});
}

/// The pixel has more in it than its corners tell.
void Integrator::wake(int pixel) {
  cells_.push_back(resting_cells_[resting_[pixel]].cell);
  resting_[pixel] = -1;
  busy_[pixel] = 1;
  guard_around(pixel);
}

/// A thing that a corner of the cell sees on the side of its pixel goes on beyond.
void Integrator::wake_across(const Cell& cell) {
  const int rows = static_cast<int>(band_.size());
  for (int k = 0; k < cell.count; ++k) {
    const int x = cell.x + (k & 1) * cell.side, y = cell.y + (k >> 1) * cell.side;
    if ((x % lattice == 0) == (y % lattice == 0)) continue; // inside, or a corner of the pixel
    const int own_u = cell.x / lattice, own_v = cell.y / lattice;
    const int u = x % lattice != 0 ? own_u : x == own_u * lattice ? own_u - 1 : own_u + 1;
    const int v = y % lattice != 0 ? own_v : y == own_v * lattice ? own_v - 1 : own_v + 1;
    if (u < 0 || u >= width_ || v < 0 || v >= rows) continue;
    const int beyond = v * width_ + u;
    if (resting_[beyond] < 0) continue;
    const Cell& other = resting_cells_[resting_[beyond]].cell;
    if (samples_[cell.corners[k]].signature != samples_[other.corners[0]].signature) wake(beyond);
  }
}

/// A thin thing that was found in a pixel may go on in its neighbours between their corners.
void Integrator::guard_around(int pixel) {
  const int x = pixel % width_, y = pixel / width_, rows = static_cast<int>(band_.size());
  for (int v = std::max(0, y - 1); v <= std::min(rows - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
      const int neighbour = v * width_ + u;
      if (!guarded_[neighbour] && resting_[neighbour] >= 0) probe(resting_[neighbour]);
      guarded_[neighbour] = 1;
    }
  }
}

/// What is known from the corners of all cells that are being worked at.
void Integrator::look_around() {
  for (const int resting : std::exchange(probed_, {})) {
    const int pixel = resting_cells_[resting].cell.pixel;
    if (resting_[pixel] >= 0 && !is_plain(resting_cells_[resting])) wake(pixel);
  }
  for (std::size_t k = 0; k < cells_.size(); ++k) { // which grows by those that wake
    const Cell cell = cells_[k];
    for (int corner = 0; corner < cell.count; ++corner) {
      const core::Color& radiance = samples_[cell.corners[corner]].radiance;
      lowest_[cell.pixel] = glm::min(lowest_[cell.pixel], radiance);
      highest_[cell.pixel] = glm::max(highest_[cell.pixel], radiance);
    }
    if (cell.side > 0 && cell.side < lattice) wake_across(cell);
    if (busy_[cell.pixel] || sees_one_thing(cell)) continue;
    busy_[cell.pixel] = 1;
    guard_around(cell.pixel);
  }
}

} // namespace halftone::scan
