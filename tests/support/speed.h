#pragma once
// How fast something is, on a machine that has other things to do.

#include <algorithm>
#include <chrono>
#include <limits>

namespace halftone::test {

/// The shortest of so many runs, in milliseconds: what else the machine does makes a run longer, never
/// shorter.
template<typename Task>
double best_of(int runs, const Task& task) {
  double best = std::numeric_limits<double>::infinity();
  for (; runs > 0; --runs) {
    const auto start = std::chrono::steady_clock::now();
    task();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count());
  }
  return best;
}

/// Rounds of measuring at most, until one tells that the bound is kept. On a quiet machine it is the first.
inline constexpr int most_rounds = 40;

} // namespace halftone::test
