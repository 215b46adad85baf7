#include "skip.h"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace halftone::test {

void skip(const std::string& reason) {
  const char* const refusal = std::getenv("HALFTONE_NO_SKIP");
  if (refusal != nullptr && *refusal != '\0') FAIL("HALFTONE_NO_SKIP is set, and skipped was: " << reason);
  WARN("skipped: " << reason);
}

void skip_anywhere(const std::string& reason) { WARN("skipped: " << reason); }

} // namespace halftone::test
