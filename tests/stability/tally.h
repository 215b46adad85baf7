#pragma once
// What a family of cases came to.

#include <concepts>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace halftone::test {

struct Tally {
  std::uint64_t cases = 0;
  std::uint64_t failures = 0;
  double worst = 0;  ///< of the error that the family measures
  std::string where; ///< the case of the worst error, or of the first failure: enough to repeat it

  /// One more case. error: its own; failed: beyond the bound.
  void add(double error, bool failed, const std::string& which);

  /// The same where cases are so short that naming each would take as long as they do: which() is asked where
  /// it is needed.
  template<std::invocable Which>
  void add(double error, bool failed, Which which) {
    add(error, failed, failed || error > worst ? which() : std::string());
  }

  /// Those of the seeds that follow.
  void join(const Tally& later);
};

/// Prints "family: cases, failures, worst, where" as a warning, which Catch shows whether the case passes or
/// not; and as a row of the table in the file that HALFTONE_STABILITY_TABLE names (report.sh).
void tell(const std::string& family, const Tally& tally);

/// One family: each(seed, tally) for seeds from 1 on; then its line is printed.
template<typename Each>
Tally tally_of(const std::string& family, std::uint64_t seeds, Each each) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) each(seed, tally);
  tell(family, tally);
  return tally;
}

/// each(seed, sums) for seeds from 1 on, in one block for each thread; the same for any number of threads.
/// Sums: a Tally, or several that are joined alike.
template<typename Sums, typename Each>
Sums over_seeds(std::uint64_t seeds, unsigned threads, Each each) {
  std::vector<Sums> blocks(threads);
  std::vector<std::thread> workers;
  for (unsigned k = 0; k < threads; ++k)
    workers.emplace_back([&, k] {
      for (std::uint64_t seed = seeds * k / threads; seed < seeds * (k + 1) / threads; ++seed)
        each(seed + 1, blocks[k]);
    });
  for (std::thread& worker : workers) worker.join();
  Sums all;
  for (const Sums& block : blocks) all.join(block);
  return all;
}

} // namespace halftone::test
