// Multi-scanning (Tadamura, Nakamae, Nishita c. 1986, section 3.4.1, figure 4): each pixel's piece of a
// virtual scanline is cut at the exact boundaries in it and every part sampled at its middle; then area
// weighting.
//
// Invariant: the parts of a virtual scanline tile it, so a pixel's weights add up to one.

#include <halftone/scan/scanner.h>

#include "converge.h"
#include "intervals.h"
#include "stretches.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

/// More boundaries of a pattern than this in a pixel are sampled at even distances instead of cut.
constexpr int most_changes = 16;

/// A row that is being added up.
struct Sum {
  Row row;
  double weight = 0; ///< of one virtual scanline

  /// Adds radiance to all pixels between left and right, in proportion to the width that they share.
  void add(double left, double right, const core::Color& radiance) {
    const int last = static_cast<int>(row.radiance.size()) - 1;
    for (int x = std::clamp(static_cast<int>(left), 0, last); x <= last && x < right; ++x) {
      const double width = std::min(right, x + 1.0) - std::max(left, x * 1.0);
      if (width > 0) row.radiance[x] += radiance * (width * weight);
    }
  }

  PixelNote& note_at(double x) {
    return row.notes[std::clamp(static_cast<int>(x), 0, static_cast<int>(row.notes.size()) - 1)];
  }
};

/// One sample in the middle of each part of a stretch whose lights are known.
void add_flat(const Frame& frame, const ScreenFace& face, const Stretch& stretch, double y, Sum& sum,
              Counts& counts) {
  for (double left = stretch.left; left < stretch.right;) {
    const double right = std::min(stretch.right, std::floor(left) + 1);
    std::vector<double> cuts;
    if (auto changes = pattern_changes(frame, face, y, left, right, most_changes))
      cuts = std::move(*changes);
    else
      for (int k = 1; k < most_changes; ++k) cuts.push_back(left + (right - left) * k / most_changes);
    cuts.push_back(right);
    for (const double end : cuts) {
      const double middle = (left + end) / 2;
      sum.add(left, end, shade_flat(frame, face, stretch.lights, middle, y, counts.rays).radiance);
      ++sum.note_at(middle).samples;
      ++counts.samples;
      left = end;
    }
  }
}

/// Each sample stands for the part of the stretch that is nearer to it than to its neighbours.
void add_sampled(const Sampled& stretch, Sum& sum, Counts& counts) {
  double left = stretch.left;
  for (std::size_t i = 0; i < stretch.samples.size(); ++i) {
    const Sample& sample = stretch.samples[i];
    const double right =
        i + 1 < stretch.samples.size() ? (sample.x + stretch.samples[i + 1].x) / 2 : stretch.right;
    sum.add(left, right, sample.radiance);
    PixelNote& note = sum.note_at(sample.x);
    ++note.samples;
    note.rays += sample.rays;
    note.traced = note.traced || !stretch.bodies.empty();
    ++counts.samples;
    left = right;
  }
}

/// Whether the shading jumps inside the stretch at places that have to be found: shadows of round or
/// transparent bodies, and a stand-in's normal that turns over.
bool needs_convergence(const Frame& frame, const ScreenFace& face, const Stretch& stretch, double y) {
  if (stretch.is_uncertain()) return true;
  if (!frame.world.bodies[face.body].faces[face.face].rounded) return false;
  const bool turned_at_left = is_turned(frame, face, stretch.left, y);
  return is_turned(frame, face, (stretch.left + stretch.right) / 2, y) != turned_at_left ||
         is_turned(frame, face, stretch.right, y) != turned_at_left;
}

void note_interval(const Interval& interval, Sum& sum) {
  for (double x = interval.left; x < interval.right; x = std::floor(x) + 1) ++sum.note_at(x).intervals;
}

/// The bodies that an eye ray in the interval can hit first.
std::vector<int> first_bodies(const Frame& frame, const Interval& interval) {
  std::vector<int> bodies = interval.candidates;
  if (interval.face >= 0) {
    const int body = frame.faces[interval.face].body;
    bodies.insert(std::lower_bound(bodies.begin(), bodies.end(), body), body);
  }
  return bodies;
}

} // namespace

Scanner::Scanner(const Frame& frame)
    : frame_(frame),
      order_(frame.world, frame.hulls),
      shadows_(frame.shadows) {}

Row Scanner::scan(int y, int lines) {
  const int width = frame_.world.camera.width;
  Sum sum{{std::vector<core::Color>(width, core::black), std::vector<PixelNote>(width)}, 1.0 / lines};
  std::vector<Sampled> sampled;
  const Active active = active_in(frame_, y, y + 1);

  for (int line = 0; line < lines; ++line) {
    const double height = y + (line + 0.5) / lines;
    ++counts.virtual_lines;
    for (const Interval& interval : visible_intervals(frame_, active, order_, height)) {
      ++counts.intervals;
      note_interval(interval, sum);
      if (!interval.candidates.empty()) {
        sampled.push_back({interval.left, interval.right, height, first_bodies(frame_, interval)});
      } else if (interval.face < 0) {
        sum.add(interval.left, interval.right, frame_.world.background);
      } else {
        for (Stretch& stretch : stretches(frame_, shadows_, interval, height)) {
          if (needs_convergence(frame_, frame_.faces[interval.face], stretch, height))
            sampled.push_back(
                {stretch.left, stretch.right, height, {}, interval.face, std::move(stretch.lights)});
          else
            add_flat(frame_, frame_.faces[interval.face], stretch, height, sum, counts);
        }
      }
    }
  }

  // As many steps a pixel in x as half the lines in y: raising the lines refines both.
  converge(frame_, sampled, std::max(1, lines / 2), counts.rays);
  for (const Sampled& stretch : sampled) add_sampled(stretch, sum, counts);
  for (const PixelNote& note : sum.row.notes) counts.traced_pixels += note.traced ? 1 : 0;
  return std::move(sum.row);
}

} // namespace halftone::scan
