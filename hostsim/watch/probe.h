#pragma once
// What there is to know about a pixel of the screen, in words.

#include <halftone/watch/player.h>

#include <cstdint>
#include <string>
#include <vector>

namespace halftone::watch {

/// Lines of at most 60 characters: what is seen there and why, and the command that wrote it. Column and row
/// from 0 to 511.
std::vector<std::string> describe_pixel(const Player& player, std::uint16_t x, std::uint16_t y);

} // namespace halftone::watch
