#pragma once
// What a misspelt word was meant to be. The scene's reader has the same for its keys; this room knows nothing
// of the engine.

#include <span>
#include <string>
#include <string_view>

namespace halftone::protocol {

/// `; did you mean "width"?` where a known word is near: at most a third of its letters, to the nearest
/// whole, inserted, deleted, changed or swapped with a neighbour. Else `; known are a, b, c`.
std::string advice_on(std::string_view word, std::span<const std::string_view> known);

} // namespace halftone::protocol
