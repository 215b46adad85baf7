#pragma once
// The characters that texts of the protocol are made of.

namespace halftone::protocol {

/// Of ASCII, the blank among them.
constexpr bool is_printable(unsigned char character) { return character >= 0x20 && character < 0x7F; }

} // namespace halftone::protocol
