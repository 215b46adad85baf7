#pragma once
// Cost against the number of objects, on generated fields.

#include "fields.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::bench {

struct Grown {
  int objects = 0;
  double prepare_seconds = 0;       ///< wall time
  double render_seconds = 0;        ///< wall time
  double processor_seconds = 0;     ///< of all threads, from the scene to the last row
  std::uint64_t comparisons = 0;    ///< render::Statistics::comparisons
  std::uint64_t prepared_bytes = 0; ///< render::Statistics::prepared_bytes
};

struct Growth {
  FieldKind kind = FieldKind::flat;
  std::vector<Grown> runs; ///< by number of objects
};

std::string_view name(FieldKind kind);

/// Draws one field.
Grown grow(const Field& field, int threads);

/// The exponent b of value ~ objects^b that fits the runs best, by least squares in the logarithms; nothing
/// for fewer than two numbers of objects.
std::optional<double> exponent(const std::vector<Grown>& runs,
                               const std::function<double(const Grown&)>& value);

std::string text_of(const std::vector<Growth>& all);
std::string csv_of(const std::vector<Growth>& all);
std::string json_of(const std::vector<Growth>& all);

} // namespace halftone::bench
