#include "picture.h"

#include <algorithm>
#include <cstddef>

namespace halftone::display {

namespace {

constexpr std::size_t row_size = screen_width * bytes_a_pixel;

} // namespace

bool Picture::put(const Frame& frame) {
  const std::scoped_lock lock(mutex_);
  const std::uint64_t next = state_ + 1;
  bool has_changed = false;
  std::array<std::uint8_t, row_size> row{};
  // Between the first and the last row that changed most may be as they were.
  for (int y = frame.changed.first; y < frame.changed.first + frame.changed.count; ++y) {
    const std::uint8_t* rgb = &frame.rgb[static_cast<std::size_t>(y) * screen_width * 3];
    for (std::size_t x = 0; x < screen_width; ++x)
      std::copy_n(rgb + 3 * x, 3, row.begin() + static_cast<std::ptrdiff_t>(bytes_a_pixel * x));
    const auto kept = pixels_.begin() + y * static_cast<std::ptrdiff_t>(row_size);
    if (std::equal(row.begin(), row.end(), kept)) continue;
    std::copy(row.begin(), row.end(), kept);
    changed_at_[static_cast<std::size_t>(y)] = next;
    has_changed = true;
  }
  if (has_changed) state_ = next;
  return has_changed;
}

std::vector<Rows> Picture::update(std::span<std::uint8_t> copy, std::uint64_t& seen) const {
  const std::scoped_lock lock(mutex_);
  std::vector<Rows> runs;
  for (int y = 0; y < screen_height; ++y) {
    if (changed_at_[static_cast<std::size_t>(y)] <= seen) continue;
    const auto begin = y * static_cast<std::ptrdiff_t>(row_size);
    std::copy_n(pixels_.begin() + begin, row_size, copy.begin() + begin);
    if (runs.empty() || runs.back().first + runs.back().count != y) runs.push_back({y, 0});
    ++runs.back().count;
  }
  seen = state_;
  return runs;
}

} // namespace halftone::display
