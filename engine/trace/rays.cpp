#include "rays.h"

#include <algorithm>

namespace halftone::trace {

void Rays::grow() {
  const std::size_t size = std::max<std::size_t>(64, 2 * count);
  for (std::vector<double>* column : {&origin_x, &origin_y, &origin_z, &direction_x, &direction_y,
                                      &direction_z, &weight_r, &weight_g, &weight_b})
    column->resize(size);
  for (std::vector<int>* column : {&surface, &inside, &sample}) column->resize(size);
  for (std::vector<std::uint8_t>* column : {&outward, &in_gap}) column->resize(size);
  gap.resize(size);
}

Touching Rays::adopted(const Touching& touching, const Rays& from) {
  const Touching own{touching.opaque, static_cast<int>(mets.size()), touching.count};
  const auto entries = from.entries(touching);
  mets.insert(mets.end(), entries.begin(), entries.end());
  return own;
}

Gap Rays::adopted(const Gap& theirs, const Rays& from) {
  const Touching ahead = adopted(theirs.ahead, from);
  return {ahead, adopted(theirs.behind, from)};
}

} // namespace halftone::trace
