#pragma once
// A visible interval of a face drawn by scanlines, cut where its lighting changes.

#include "intervals.h"

#include <halftone/shadow/shadows.h>

#include <optional>
#include <vector>

namespace halftone::scan {

/// How a light reaches a stretch.
struct Lighting {
  bool dark = false;
  std::vector<int>
      casters; ///< bodies that may shadow a part of it, or let a part of the light through, ascending

  bool operator==(const Lighting&) const = default;
};

struct Stretch {
  double left = 0;
  double right = 0;
  std::vector<Lighting> lights; ///< one for each light of the world

  /// Whether shadow tests at points of it are needed.
  bool is_uncertain() const;
};

/// Stretches that tile the interval, in order. interval.face must not be -1.
std::vector<Stretch> stretches(const Frame& frame, shadow::Shadows& shadows, const Interval& interval,
                               double y);

/// Positions between left and right where the face's pattern changes, ascending; `most` at the most, or
/// nothing if there are more.
std::optional<std::vector<double>> pattern_changes(const Frame& frame, const ScreenFace& face, double y,
                                                   double left, double right, int most);

} // namespace halftone::scan
