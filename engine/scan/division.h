#pragma once
// A cell through which one boundary passes, divided along it.

#include "samples.h"

#include <array>
#include <optional>
#include <span>

namespace halftone::scan {

class Division {
public:
  /// Of a convex cell, by the samples at its corners in order around it, where these see two things and the
  /// boundary between the two crosses its border twice; nullopt where it cannot be so simple. width: of the
  /// bracket in which each crossing is found, as a share of the side that is crossed, > 0.
  static std::optional<Division> of(const Samples& samples, int source, std::span<const int> corners,
                                    double width);

  bool sees(std::uint64_t signature) const { return signature == seen_[0] || signature == seen_[1]; }

  enum class Progress {
    samples, ///< were asked for, and are to be evaluated before the next step
    done,
    failed, ///< a third thing was met, or the boundary is too curved
  };
  Progress advance(Samples& samples);

  /// A part of the cell, when done.
  struct Part {
    std::uint64_t seen = 0; ///< its signature
    double share = 0;       ///< of the cell's area
    core::Color mean{0};
    core::Color low{0}, high{0}; ///< of its samples
  };
  std::array<Part, 2> parts(const Samples& samples) const;

private:
  /// A side with its ends in different parts, narrowed down.
  struct Bracket {
    std::array<int, 2> ends{}; ///< in the first part, in the second
    double width = 1;          ///< share of the side
    int middle = -1;
  };

  view::ScreenPoint crossing(const Samples& samples, int bracket) const;
  std::optional<int> part_of(const Samples& samples, int sample) const;

  int source_ = 0;
  double width_ = 0;
  std::array<std::uint64_t, 2> seen_{};
  std::array<std::vector<int>, 2> corners_; ///< around the cell: the first part's from the second bracket to
                                            ///< the first, the other's back
  std::array<Bracket, 2> brackets_;
  double side_ = 0;  ///< of the cell, about
  int middle_ = -1;  ///< sample halfway between the crossings
  int beyond_ = -1;  ///< sample from there towards the other part
  double bulge_ = 0; ///< distance of these
};

} // namespace halftone::scan
