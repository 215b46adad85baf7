#pragma once
// What there is to know about a pixel of the screen, in words.

#include <halftone/watch/player.h>

#include <halftone/inspect/who.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halftone::watch {

/// Asks about the same pixel again and again while the stream goes on: the search for who wrote it goes on,
/// too, and begins anew only where the player has gone back, or another place in memory is seen there.
class Inquiry {
public:
  /// Lines of at most 60 characters: what is seen there and why, and the command that wrote it; or that this
  /// is looked for, which takes as long as playing the stream: so some milliseconds of it at a time. Column
  /// and row from 0 to 511. The player is always the same.
  std::vector<std::string> describe(const Player& player, std::uint16_t x, std::uint16_t y);

  /// Whether there is more to find out about what was described last.
  bool is_under_way() const { return is_under_way_; }

private:
  bool is_under_way_ = false;
  std::optional<inspect::Search> search_;
  inspect::Place place_;       ///< that it is for
  std::uint64_t position_ = 0; ///< that it has come to
};

} // namespace halftone::watch
