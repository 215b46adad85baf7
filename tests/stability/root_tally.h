#pragma once
// How far the engine's roots are from exact ones, in units of 2^-53 (D + r + c): D the distance of the line's
// origin from the middle of the solid, r the solid's size, c the middle's distance from the world's origin
// (docs/numerics.md). The bound is 64.

#include "exact_solids.h"
#include "tally.h"

#include <halftone/geometry/solids.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <thread>

namespace halftone::test {

struct RootTally {
  Tally ends;      ///< how far from the surface a line is said to end: the difference of t times sin theta
  Tally decisions; ///< where only one of the two has a hit: how far from the surface the line passes
  Tally oracle;    ///< of some lines: by how much judging with 113 bits differs

  void join(const RootTally& later) {
    ends.join(later.ends);
    decisions.join(later.decisions);
    oracle.join(later.oracle);
  }
};

inline constexpr double most_roundings = 64;
/// Twofold's errors are below 2^-100 of the numbers that enter, 2^-47 of a unit. A root moves by that over
/// the sine of the angle to the surface, and so leaves the surface by no more, but beyond the apex of a cone,
/// which a line beside a generator passes at any angle: at one of 2^-52 the oracle's own root is some 2^-8
/// units off; along an edge of a box 0.7 (3 of 1,600,000). A judge that is off by a unit decides where the
/// bound is off by a sixty-fourth.
inline constexpr double most_of_oracle = 1;

/// A line at a shape of one scene.
struct Thrown {
  geometry::Line line;
  const char* kind = "";
  double unit = 0; ///< 2^-53 (D + r + c)
  std::uint64_t seed = 0;
  int number = 0;

  std::string operator()() const {
    std::ostringstream text;
    text << "seed " << seed << ", line " << number << ", " << kind;
    return text.str();
  }
};

inline double unit_of(const scene::Body& body, const core::Vec3& origin) {
  const core::Vec3 middle = body.bounds[0] + (body.bounds[1] - body.bounds[0]) / 2.0;
  const double size = glm::length(body.bounds[1] - body.bounds[0]) / 2;
  return 0x1p-53 * (glm::length(origin - middle) + size + glm::length(middle));
}

struct RootError {
  bool is_decision = false;
  double roundings = 0;
};

/// Exact: ExactRound or ExactFlat.
template<typename Real, typename Exact>
RootError error_of_span(const Exact& exact, const std::optional<geometry::Span>& ours, const Thrown& thrown) {
  const ExactLine<Real> line(thrown.line);
  const auto height = [&](const Real& t) {
    return std::abs(static_cast<double>(exact.height_over(line.at(t)))) / thrown.unit;
  };
  const auto exactly = exact.span(line);
  const bool exists = exactly && exactly->out > 0;
  if (ours.has_value() != exists) {
    // It is rounding's to decide where the line passes at nothing from the surface, or starts there.
    const Real middle = exists ? (exactly->in + exactly->out) / 2 : (Real(ours->in.t) + ours->out.t) / 2;
    return {true, std::min(height(middle), height(0))};
  }
  if (!exists) return {};
  if (!std::isfinite(ours->in.t) || !std::isfinite(ours->out.t))
    return {false, std::numeric_limits<double>::infinity()};
  // Also half way to the exact end, so that it is no other place of the surface.
  return {false, std::max({height(ours->in.t), height((ours->in.t + exactly->in) / 2), height(ours->out.t),
                           height((ours->out.t + exactly->out) / 2)})};
}

inline void add(RootTally& tally, const RootError& error, const Thrown& thrown) {
  const bool failed = !(error.roundings <= most_roundings);
  tally.ends.add(error.is_decision ? 0 : error.roundings, failed && !error.is_decision, thrown);
  tally.decisions.add(error.is_decision ? error.roundings : 0, failed && error.is_decision, thrown);
}

struct RootCounts {
  std::uint64_t seeds = 0; ///< one shape each
  int lines = 0;           ///< at each shape
  bool is_long = false;    ///< on all threads
};

/// Counts one family, tells its three tallies, and checks that none failed, nor passed for lack of cases.
template<typename Each>
void check_roots_of(const std::string& shape, const RootCounts& counts, Each each) {
  const unsigned threads = counts.is_long ? std::max(1U, std::thread::hardware_concurrency()) : 1;
  const auto tally = over_seeds<RootTally>(counts.seeds, threads, each);
  tell("roots: " + shape + ", ends", tally.ends);
  tell("roots: " + shape + ", hit or miss", tally.decisions);
  tell("roots: " + shape + ", judged with 113 bits", tally.oracle);
  CHECK(tally.ends.cases == counts.seeds * static_cast<std::uint64_t>(counts.lines));
  CHECK(tally.oracle.cases > 0);
  CHECK(tally.ends.failures == 0);
  CHECK(tally.decisions.failures == 0);
  CHECK(tally.oracle.failures == 0);
}

} // namespace halftone::test
