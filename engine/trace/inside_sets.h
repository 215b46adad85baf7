#pragma once
// Sets of solids that a ray can be in, as small numbers: a ray carries one number, whatever it is in.

#include "media.h"

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace halftone::trace {

/// Remembers every set that it was asked for. Numbers mean nothing outside of it.
class InsideSets {
public:
  explicit InsideSets(const Media& media) : media_(media) {}

  /// Of bodies in ascending order.
  int number_of(const std::vector<int>& bodies);

  /// The set without the body if it was in it, and with the body if it was not.
  int toggled(int set, int body) {
    const Set& known = sets_[set]; // most rays do there what the last one did
    return known.toggled_body == body ? known.toggled_set : found_toggled(set, body);
  }

  /// Ascending; valid until the next call of another function.
  std::span<const int> bodies(int set) const {
    return {bodies_.data() + sets_[set].first, static_cast<std::size_t>(sets_[set].count)};
  }

  /// The glass solid of the set that stands last in the file, or -1 for air.
  int medium(int set) const { return sets_[set].medium; }

private:
  struct Set {
    int first = 0; ///< of bodies_
    int count = 0;
    int medium = -1;
    int toggled_body = -1; ///< the last one that was asked for, and the set that came of it
    int toggled_set = -1;
  };

  int found_toggled(int set, int body);

  const Media& media_;
  std::vector<Set> sets_;
  std::vector<int> bodies_;
  std::unordered_map<std::uint64_t, int> toggled_; ///< by set and body
  std::map<std::vector<int>, int> numbers_;
};

} // namespace halftone::trace
