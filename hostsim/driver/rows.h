#pragma once
// Rows in messages.

#include <string>
#include <vector>

namespace halftone::driver {

/// Of the rows from `first` on, `count` of them, those that are not marked, counted from `first`.
std::vector<int> rows_without(const std::vector<bool>& marks, int first, int count);

/// As in "rows 3, 7 to 9". At least one row, ascending.
std::string name(const std::vector<int>& rows);

} // namespace halftone::driver
