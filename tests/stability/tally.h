#pragma once
// What a family of cases came to.

#include <cstdint>
#include <string>

namespace halftone::test {

struct Tally {
  std::uint64_t cases = 0;
  std::uint64_t failures = 0;
  double worst = 0;  ///< of the error that the family measures
  std::string where; ///< the case of the worst error, or of the first failure: enough to repeat it

  /// One more case. error: its own; failed: beyond the bound.
  void add(double error, bool failed, const std::string& which);
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

} // namespace halftone::test
