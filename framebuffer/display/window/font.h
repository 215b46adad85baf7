#pragma once
// Letters for the words of the window: 5 x 7 pixels each and two below the line, drawn for it.

#include <array>
#include <cstdint>

namespace halftone::display {

inline constexpr int glyph_width = 5;
inline constexpr int glyph_height = 9;
inline constexpr char first_glyph = ' ';
inline constexpr int glyph_count = 95; ///< printable ASCII

/// Rows from the top, of which the lowest five bits are pixels, the highest of them at the left.
using Glyph = std::array<std::uint8_t, glyph_height>;

/// Of a character; of one that has none, a box.
const Glyph& glyph_of(char character);

} // namespace halftone::display
