#include "rows.h"

#include <cstddef>

namespace halftone::driver {

std::vector<int> rows_without(const std::vector<bool>& marks, int first, int count) {
  std::vector<int> rows;
  for (int row = 0; row < count; ++row)
    if (!marks[static_cast<std::size_t>(first + row)]) rows.push_back(row);
  return rows;
}

std::string name(const std::vector<int>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i + 1;
    while (end < rows.size() && rows[end] == rows[end - 1] + 1) ++end;
    if (!text.empty()) text += ", ";
    text += std::to_string(rows[i]);
    if (end - i > 1) text += " to " + std::to_string(rows[end - 1]);
    i = end;
  }
  return (rows.size() == 1 ? "row " : "rows ") + text;
}

} // namespace halftone::driver
