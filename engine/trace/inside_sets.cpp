// Our own: the sets form a graph whose edges are single solids, filled in as rays walk it, so that a step
// costs one look-up and no memory once the sets of a picture are known.
//
// Invariant: one number a set.

#include "inside_sets.h"

#include "signature.h"

#include <algorithm>

namespace halftone::trace {

int InsideSets::number_of(const std::vector<int>& bodies) {
  const auto [entry, is_new] = numbers_.try_emplace(bodies, static_cast<int>(sets_.size()));
  if (is_new) {
    Set set{static_cast<int>(bodies_.size()), static_cast<int>(bodies.size())};
    for (const int body : bodies)
      if (media_[body].is_glass) set.medium = body;
    sets_.push_back(set);
    bodies_.insert(bodies_.end(), bodies.begin(), bodies.end());
  }
  return entry->second;
}

int InsideSets::found_toggled(int set, int body) {
  const auto [entry, is_new] = toggled_.try_emplace(pair_of(set, body), -1);
  if (is_new) {
    const auto known = bodies(set);
    std::vector<int> changed(known.begin(), known.end());
    const auto place = std::lower_bound(changed.begin(), changed.end(), body);
    if (place != changed.end() && *place == body)
      changed.erase(place);
    else
      changed.insert(place, body);
    entry->second = number_of(changed);
  }
  sets_[set].toggled_body = body;
  sets_[set].toggled_set = entry->second;
  return entry->second;
}

} // namespace halftone::trace
