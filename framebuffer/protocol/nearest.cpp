#include "nearest.h"

#include <algorithm>
#include <array>

namespace halftone::protocol {

namespace {

constexpr std::size_t longest = 24; // of the names in the opcode table: see the tests

/// Edit distance with swaps of neighbours (optimal string alignment, Damerau 1964), by its whole table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, longest + 1>, longest + 1> table{};
  for (std::size_t i = 0; i <= a.size(); ++i) table[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) table[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      table[i][j] = std::min(
          {table[i - 1][j] + 1, table[i][j - 1] + 1, table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
    }
  }
  return table[a.size()][b.size()];
}

} // namespace

std::string advice_on(std::string_view word, std::span<const std::string_view> known) {
  std::string_view nearest;
  std::size_t least = (word.size() + 1) / 3 + 1;
  std::string all;
  for (const std::string_view candidate : known) {
    all += all.empty() ? "" : ", ";
    all += candidate;
    if (word.size() > longest || candidate.size() > longest) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest.empty() ? "; known are " + all : "; did you mean \"" + std::string(nearest) + "\"?";
}

} // namespace halftone::protocol
