#pragma once
// m508 as a user starts it, in a folder of the test's own.

#include "support/json_keys.h"
#include "support/process.h"
#include "support/scratch.h"

#include <string>
#include <vector>

namespace halftone::test {

class Bench {
public:
  /// A raw stream, from its text form.
  void stream(const std::string& name, const std::string& text) const;
  void file(const std::string& name, const std::string& text) const { scratch.write(name, text); }
  Outcome m508(const std::vector<std::string>& arguments) const;

  Scratch scratch;
};

} // namespace halftone::test
