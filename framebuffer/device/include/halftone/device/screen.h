#pragma once
// Scan-out: from memory to what a monitor shows.

#include <halftone/device/device.h>

#include <span>

namespace halftone::device {

inline constexpr std::uint32_t cursor_size = 16; ///< pixels across and down

/// Whether overlay or cursor are on, and not in the dark half of their blinking.
bool is_shown(const Layer& layer, const Clock& clock);

/// Row y of the screen, 0 to 511, as 512 pixels of 3 bytes: image buffer, pan and zoom, read mask, look-up
/// tables, overlay, cursor, border, blank, at the clock's present field.
void scan_out(const Device& device, std::uint32_t y, std::span<std::uint8_t> row);

/// The whole screen, rows from the top.
Bytes screen(const Device& device);

} // namespace halftone::device
