#pragma once

#include <cstdint>
#include <vector>

namespace halftone::scan {

/// Numbers by 64-bit keys that are well mixed already: open addressing with linear probing (D. Knuth, "The
/// Art of Computer Programming", volume 3, 6.4, algorithm L), at most half full. Nothing is removed.
class NumberTable {
public:
  /// The number that the key has; `number`, 0 or more, if it had none so far.
  int number_of(std::uint64_t key, int number);

private:
  struct Entry {
    std::uint64_t key = 0;
    int number = -1; ///< none
  };

  std::vector<Entry> entries_ = std::vector<Entry>(64); ///< a power of two of them
  std::size_t count_ = 0;
};

} // namespace halftone::scan
