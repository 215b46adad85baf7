#include "number_table.h"

#include <utility>

namespace halftone::scan {

int NumberTable::number_of(std::uint64_t key, int number) {
  const std::size_t last = entries_.size() - 1;
  std::size_t place = key & last;
  for (; entries_[place].number >= 0; place = (place + 1) & last)
    if (entries_[place].key == key) return entries_[place].number;
  entries_[place] = {key, number};
  if (2 * ++count_ > entries_.size()) {
    const std::vector<Entry> all = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
    count_ = 0;
    for (const Entry& entry : all)
      if (entry.number >= 0) number_of(entry.key, entry.number);
  }
  return number;
}

} // namespace halftone::scan
