#pragma once
// What a misspelt word was meant to be.

#include <string>
#include <string_view>
#include <vector>

namespace halftone::scene {

/// The word in quotes, on one line: control characters replaced, the end of a long one left out.
std::string in_quotes(std::string_view word);

/// `did you mean "radius"?` where a known word is near, else `otherwise`. Near is at most a third of its
/// letters (to the nearest whole) inserted, deleted, changed or swapped with a neighbour; case counts for
/// nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known,
                         const std::string& otherwise);

/// `a, b, c`
std::string listed(const std::vector<std::string_view>& words);

} // namespace halftone::scene
