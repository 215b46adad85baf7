#pragma once
// Bytes that a line of the text form can stand for where no frame limits them: assembling is bounded by its
// text, and lines are of a length that editors take.

#include <cstddef>

namespace halftone::protocol {

inline constexpr std::size_t line_limit = 65'536; ///< accepted
inline constexpr std::size_t line_of_bytes = 512; ///< written

} // namespace halftone::protocol
