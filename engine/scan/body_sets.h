#pragma once
// Sets of bodies as small numbers, so that pieces of a pixel carry one number each.

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace halftone::scan {

/// 0 is the empty set. Numbers mean nothing outside of it.
class BodySets {
public:
  BodySets() { number_of({}); }

  int with(int set, int body);

  /// Ascending; valid until the next call of with.
  std::span<const int> bodies(int set) const { return sets_[set]; }

private:
  int number_of(const std::vector<int>& bodies);

  std::vector<std::vector<int>> sets_;
  std::map<std::vector<int>, int> numbers_;
  std::unordered_map<std::uint64_t, int> with_; ///< by set and body
};

} // namespace halftone::scan
