#pragma once
// The screen, between the thread that shows it and those that send it.

#include <halftone/display/display.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace halftone::display {

inline constexpr std::size_t bytes_a_pixel = 4; ///< red, green, blue, and one that is 0

/// The screen as clients take it: what is sent is a copy that nobody writes to. Any thread may call.
class Picture {
public:
  /// Whether any pixel has changed.
  bool put(const Frame& frame);

  /// Brings a copy up to date. `seen` is the state that it is of, 0 for none, and becomes that of now. The
  /// rows that differ, in runs.
  std::vector<Rows> update(std::span<std::uint8_t> copy, std::uint64_t& seen) const;

private:
  mutable std::mutex mutex_;
  std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(screen_width * screen_height * bytes_a_pixel);
  std::uint64_t state_ = 0;                               ///< counts frames that changed something
  std::array<std::uint64_t, screen_height> changed_at_{}; ///< the state in which each row changed last
};

} // namespace halftone::display
