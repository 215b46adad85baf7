#include "tally.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace halftone::test {

void Tally::add(double error, bool failed, const std::string& which) {
  ++cases;
  const bool is_first_failure = failed && failures == 0;
  if (failed) ++failures;
  if (is_first_failure || (error > worst && (failures == 0 || failed))) where = which;
  if (error > worst) worst = error;
}

void Tally::join(const Tally& later) {
  if ((later.failures > 0 && failures == 0) ||
      (later.worst > worst && (later.failures > 0) == (failures > 0)))
    where = later.where;
  cases += later.cases;
  failures += later.failures;
  worst = std::max(worst, later.worst);
}

void tell(const std::string& family, const Tally& tally) {
  std::ostringstream text;
  text << family << ": " << tally.cases << " cases, " << tally.failures << " failures, worst " << tally.worst
       << " (" << tally.where << ")";
  WARN(text.str());
  if (const char* table = std::getenv("HALFTONE_STABILITY_TABLE"))
    std::ofstream(table, std::ios::app) << "| " << family << " | " << tally.cases << " | " << tally.failures
                                        << " | " << tally.worst << " | " << tally.where << " |\n";
}

} // namespace halftone::test
