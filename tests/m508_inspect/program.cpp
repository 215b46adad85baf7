#include "program.h"

#include <halftone/protocol/text.h>

namespace halftone::test {

void Bench::stream(const std::string& name, const std::string& text) const {
  const auto bytes = protocol::assemble(text);
  scratch.write(name, {bytes.begin(), bytes.end()});
}

Outcome Bench::m508(const std::vector<std::string>& arguments) const {
  return run_halftone(arguments, {.folder = scratch.path()});
}

} // namespace halftone::test
