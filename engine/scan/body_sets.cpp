#include "body_sets.h"

#include <algorithm>

namespace halftone::scan {

int BodySets::number_of(const std::vector<int>& bodies) {
  const auto [known, is_new] = numbers_.try_emplace(bodies, static_cast<int>(sets_.size()));
  if (is_new) sets_.push_back(bodies);
  return known->second;
}

int BodySets::with(int set, int body) {
  const auto key = static_cast<std::uint64_t>(set) << 32 | static_cast<std::uint64_t>(body);
  const auto known = with_.find(key);
  if (known != with_.end()) return known->second;
  std::vector<int> bodies = sets_[set];
  const auto place = std::lower_bound(bodies.begin(), bodies.end(), body);
  if (place == bodies.end() || *place != body) bodies.insert(place, body);
  return with_[key] = number_of(bodies);
}

} // namespace halftone::scan
