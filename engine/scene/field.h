#pragma once
// Reading one value of a scene file: its type and range, and what to say where they are wrong.

#include "document.h"
#include "number_range.h"

#include <halftone/core/vector.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halftone::scene {

/// A value on its way into the scene, and how messages call it: "radius" in sphere. All views must outlive
/// it.
struct Field {
  const Value& value;
  std::string_view file;
  std::string_view table;
  std::string_view key;
};

/// Throws core::InputError at the value's place.
[[noreturn]] void fail(const Field& field, const std::string& problem, std::string_view advice);

/// Fails with: expected EXPECTED for KEY in TABLE, found the value.
[[noreturn]] void refuse(const Field& field, std::string_view expected, std::string_view advice);

/// Positive numbers are at least smallest_number, and what is nearer to 0 without a bound is 0; a fraction is
/// 0 to 1.
enum class Bound { none, not_negative, positive, fraction };

// Each reads a value of its type, or refuses. Integers are taken for numbers, but not the other way round.
double number(const Field& field, Bound bound = Bound::none);
int integer(const Field& field, int least, int most);
const std::string& text(const Field& field);
core::Vec3 vector(const Field& field);
core::Color color(const Field& field, Bound bound);
const Value::Array& array(const Field& field, std::string_view of, std::string_view advice);
std::vector<core::Vec3> vectors(const Field& field);

/// Refuses a text that is none of the known words.
[[noreturn]] void refuse_word(const Field& field, const std::vector<std::string_view>& known);

/// The meaning of the field's text, one of the words.
template<class T>
T choice(const Field& field, std::initializer_list<std::pair<std::string_view, T>> words) {
  const std::string& word = text(field);
  std::vector<std::string_view> known;
  for (const auto& [name, meaning] : words) {
    if (word == name) return meaning;
    known.push_back(name);
  }
  refuse_word(field, known);
}

} // namespace halftone::scene
