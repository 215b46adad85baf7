#pragma once
// m508 as a user starts it, in a folder of the test's own.

#include "../cli/process.h"
#include "support/scratch.h"

#include <set>
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

/// All keys of a JSON text, as docs/json.md writes them.
std::set<std::string> keys_of(const std::string& text);

/// The first column of the table under the heading of docs/json.md.
std::set<std::string> documented(const std::string& heading);

} // namespace halftone::test
