#pragma once
// Verdicts as JUnit XML, as continuous integration reads it.

#include <halftone/inspect/check.h>

#include <string>
#include <vector>

namespace halftone::m508 {

/// One suite, named after the recording, with a case for each check.
std::string junit(const std::string& recording, const std::vector<inspect::Check>& checks,
                  const std::vector<inspect::Verdict>& verdicts);

} // namespace halftone::m508
