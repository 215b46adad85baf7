#include "suggestion.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace halftone::scene {

namespace {

std::string in_lower_case(std::string_view word) {
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Edit distance with swaps of neighbours (optimal string alignment, Damerau 1964), by three rows of its
/// table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> above_that(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    above_that.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], above_that[j - 2] + 1);
    }
  }
  return row[b.size()];
}

} // namespace

std::string in_quotes(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string shown(word.substr(0, most));
  while (shown.size() < word.size() && !shown.empty() &&
         (static_cast<unsigned char>(word[shown.size()]) & 0xC0) == 0x80)
    shown.pop_back(); // not in the middle of a UTF-8 sequence
  if (shown.size() < word.size()) shown += "...";
  for (char& c : shown)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  // U+0080 to U+009F, which terminals obey too, and what turns the direction of writing.
  for (std::size_t i = 0; i + 1 < shown.size(); ++i) {
    const auto byte = [&](std::size_t k) {
      return static_cast<unsigned char>(i + k < shown.size() ? shown[i + k] : 0);
    };
    const bool is_control = byte(0) == 0xC2 && byte(1) < 0xA0;
    const bool is_turn = byte(0) == 0xE2 && ((byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) ||
                                             (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9));
    if (is_control || is_turn) shown.replace(i, is_turn ? 3 : 2, " ");
  }
  return '"' + shown + '"';
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known,
                         const std::string& otherwise) {
  constexpr std::size_t longest = 64; // no key is near that long, and the table is quadratic
  if (word.size() > longest) return otherwise;
  const std::string lower = in_lower_case(word);
  std::string_view nearest;
  std::size_t least = (word.size() + 1) / 3 + 1;
  for (const std::string_view candidate : known) {
    if (candidate.size() > longest) continue;
    const std::size_t distance = edit_distance(lower, in_lower_case(candidate));
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest.empty() ? otherwise : "did you mean " + in_quotes(nearest) + "?";
}

std::string listed(const std::vector<std::string_view>& words) {
  std::string list;
  for (const std::string_view word : words) {
    if (!list.empty()) list += ", ";
    list += word;
  }
  return list;
}

} // namespace halftone::scene
