// Built where Embree is not installed.

#include "contender.h"

namespace halftone::bench {

void add_embree(Contenders&, int, std::vector<std::string>& missing) {
  missing.push_back("Embree 3 was not there when this was built (Debian: libembree-dev)");
}

} // namespace halftone::bench
