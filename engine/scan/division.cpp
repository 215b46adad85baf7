// Convergence on the boundary between two things (Tadamura et al. 1986, figure 5, in the plane): bisection of
// the two sides that it crosses, then a parabola through the crossings and a point of the boundary halfway
// between them (Simpson).
//
// Invariant: the shares of the two parts are positive or nought and add up to 1.

#include "division.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

using view::ScreenPoint;

ScreenPoint halfway(const ScreenPoint& a, const ScreenPoint& b) {
  return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
}

double distance(const ScreenPoint& a, const ScreenPoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Twice the area, signed.
double twice_area(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

} // namespace

std::optional<Division> Division::of(const Samples& samples, int source, std::span<const int> corners,
                                     double width) {
  const std::size_t count = corners.size();
  const auto seen = [&](std::size_t k) { return samples[corners[k % count]].signature; };
  // The first part begins where its predecessor is in the other.
  std::size_t first = 0;
  while (first < count && seen(first) == seen(first + count - 1)) ++first;
  if (first == count) return std::nullopt;
  Division division;
  division.source_ = source;
  division.width_ = width;
  division.seen_ = {seen(first), seen(first + count - 1)};
  std::size_t size = 1;
  while (seen(first + size) == division.seen_[0]) ++size;
  for (std::size_t k = 0; k < count; ++k) {
    const int part = k < size ? 0 : 1;
    if (seen(first + k) != division.seen_[part]) return std::nullopt;
    division.corners_[part].push_back(corners[(first + k) % count]);
  }
  const auto& [ours, theirs] = division.corners_;
  division.brackets_[0].ends = {ours.back(), theirs.front()};
  division.brackets_[1].ends = {ours.front(), theirs.back()};
  for (const Bracket& bracket : division.brackets_)
    division.side_ += distance(samples[bracket.ends[0]].at, samples[bracket.ends[1]].at) / 2;
  return division;
}

std::optional<int> Division::part_of(const Samples& samples, int sample) const {
  for (int part = 0; part < 2; ++part)
    if (samples[sample].signature == seen_[part]) return part;
  return std::nullopt;
}

ScreenPoint Division::crossing(const Samples& samples, int bracket) const {
  const auto& ends = brackets_[bracket].ends;
  return halfway(samples[ends[0]].at, samples[ends[1]].at);
}

Division::Progress Division::advance(Samples& samples) {
  if (beyond_ >= 0) {
    const auto here = part_of(samples, middle_), there = part_of(samples, beyond_);
    return there && *there != *here ? Progress::done : Progress::failed;
  }
  if (middle_ >= 0) {
    const auto part = part_of(samples, middle_);
    if (!part) return Progress::failed;
    const ScreenPoint p = crossing(samples, 0), q = crossing(samples, 1), middle = samples[middle_].at;
    const double length = distance(p, q);
    if (length == 0) return Progress::failed;
    bulge_ = width_ * side_;
    // The side of the first part, whichever way the corners go round. The sample may lie outside of the cell:
    // only what it sees is used.
    const ScreenPoint across{(q.y - p.y) / length, (p.x - q.x) / length};
    const ScreenPoint& corner = samples[corners_[0][0]].at;
    const double sign =
        twice_area(p, q, corner) * twice_area(p, q, {p.x + across.x, p.y + across.y}) > 0 ? 1 : -1;
    const double by = *part == 0 ? -sign * bulge_ : sign * bulge_;
    beyond_ = samples.at(source_, {middle.x + by * across.x, middle.y + by * across.y});
    return Progress::samples;
  }
  bool is_narrow = true;
  for (Bracket& bracket : brackets_) {
    if (bracket.middle >= 0) {
      const auto part = part_of(samples, bracket.middle);
      if (!part) return Progress::failed;
      bracket.ends[*part] = bracket.middle;
      bracket.middle = -1;
      bracket.width /= 2;
    }
    if (bracket.width <= width_) continue;
    is_narrow = false;
    bracket.middle = samples.at(source_, halfway(samples[bracket.ends[0]].at, samples[bracket.ends[1]].at));
  }
  if (is_narrow) middle_ = samples.at(source_, halfway(crossing(samples, 0), crossing(samples, 1)));
  return Progress::samples;
}

std::array<Division::Part, 2> Division::parts(const Samples& samples) const {
  std::array<Part, 2> parts;
  std::array<double, 2> areas{};
  const ScreenPoint p = crossing(samples, 0), q = crossing(samples, 1);
  for (int part = 0; part < 2; ++part) {
    parts[part].seen = seen_[part];
    struct Vertex {
      ScreenPoint at;
      core::Color radiance;
    };
    std::array<Vertex, 8> vertices;
    std::size_t count = 0;
    const auto add = [&](const ScreenPoint& at, int sample) {
      const core::Color& radiance = samples[sample].radiance;
      parts[part].low = count == 0 ? radiance : glm::min(parts[part].low, radiance);
      parts[part].high = count == 0 ? radiance : glm::max(parts[part].high, radiance);
      vertices[count++] = {at, radiance};
    };
    for (const int corner : corners_[part]) add(samples[corner].at, corner);
    add(part == 0 ? p : q, brackets_[part == 0 ? 0 : 1].ends[part]);
    add(part == 0 ? q : p, brackets_[part == 0 ? 1 : 0].ends[part]);
    // A fan about the mean of the corners: the same whichever way they go round.
    Vertex hub{{0, 0}, core::Color{0}};
    const double share = 1.0 / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      hub.at = {hub.at.x + share * vertices[k].at.x, hub.at.y + share * vertices[k].at.y};
      hub.radiance += share * vertices[k].radiance;
    }
    core::Color sum{0};
    for (std::size_t k = 0; k < count; ++k) {
      const Vertex &v = vertices[k], &w = vertices[(k + 1) % count];
      const double area = std::abs(twice_area(hub.at, v.at, w.at)) / 2;
      sum += area / 3 * (hub.radiance + v.radiance + w.radiance);
      areas[part] += area;
    }
    parts[part].mean = areas[part] > 0 ? sum / areas[part] : hub.radiance;
  }
  // The boundary halfway is within the bulge on the other side of the chord.
  const double all = areas[0] + areas[1];
  const double under_parabola = 2.0 / 3 * distance(p, q) * (bulge_ / 2);
  const double first = areas[0] + (part_of(samples, middle_) == 0 ? under_parabola : -under_parabola);
  parts[0].share = all > 0 ? std::clamp(first / all, 0.0, 1.0) : 1.0;
  parts[1].share = 1 - parts[0].share;
  return parts;
}

} // namespace halftone::scan
