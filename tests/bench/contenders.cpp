#include "contender.h"

namespace halftone::bench {

Contenders all_contenders(int threads, std::vector<std::string>& missing) {
  Contenders contenders;
  add_ours(contenders, threads);
  add_embree(contenders, threads, missing);
  add_povray(contenders, threads, missing);
  return contenders;
}

} // namespace halftone::bench
