#include "field.h"

#include "suggestion.h"

#include <halftone/core/error.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace halftone::scene {

namespace {

/// The shortest decimal that reads back as x; with a point, to be told from an integer.
std::string decimal(double x) {
  std::array<char, 32> digits;
  std::string shown(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  return shown.find_first_of(".en") == std::string::npos ? shown + ".0" : shown;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string described(const Value& value) {
  struct {
    std::string operator()(bool x) const { return x ? "true" : "false"; }
    std::string operator()(std::int64_t x) const { return std::to_string(x); }
    std::string operator()(double x) const { return decimal(x); }
    std::string operator()(const std::string& x) const { return "the text " + in_quotes(x); }
    std::string operator()(Value::DateOrTime) const { return "a date or time"; }
    std::string operator()(const Value::Array& x) const {
      return "an array of " + counted(x.size(), "value");
    }
    std::string operator()(const Value::Members&) const { return "a table"; }
  } constexpr words;
  return std::visit(words, value.content);
}

std::string in_words(Bound bound) {
  switch (bound) {
  case Bound::none:
    return "a number";
  case Bound::not_negative:
    return "a number >= 0";
  case Bound::positive:
    return "a number > 0";
  case Bound::fraction:
    return "a number from 0 to 1";
  }
  return {};
}

std::string advice_on_type(const Value& value, const std::string& example) {
  return std::holds_alternative<std::string>(value.content) ? "numbers stand without quotes" : example;
}

/// The three numbers of a vector or colour.
core::Vec3 three(const Field& field, Bound bound, std::string_view expected, std::string_view example) {
  const auto* elements = std::get_if<Value::Array>(&field.value.content);
  if (elements == nullptr || elements->size() != 3)
    refuse(field, expected, "write three numbers, as in " + std::string(example));
  const auto element = [&](std::size_t i) {
    return number({(*elements)[i], field.file, field.table, field.key}, bound);
  };
  const double first = element(0), second = element(1), third = element(2);
  return {first, second, third};
}

} // namespace

void fail(const Field& field, const std::string& problem, std::string_view advice) {
  throw core::InputError({std::string(field.file), field.value.position.line, field.value.position.column},
                         problem, std::string(advice));
}

void refuse(const Field& field, std::string_view expected, std::string_view advice) {
  fail(field,
       "expected " + std::string(expected) + " for " + in_quotes(field.key) + " in " +
           std::string(field.table) + ", found " + described(field.value),
       advice);
}

double number(const Field& field, Bound bound) {
  double x = 0;
  if (const auto* whole = std::get_if<std::int64_t>(&field.value.content))
    x = static_cast<double>(*whole);
  else if (const auto* real = std::get_if<double>(&field.value.content))
    x = *real;
  else
    refuse(field, in_words(bound), advice_on_type(field.value, "write a number such as 0.5"));

  if (!std::isfinite(x)) refuse(field, "a finite number", "numbers go up to 1e60");
  if (std::abs(x) > largest_number)
    refuse(field, "a number of at most 1e60 in magnitude", "larger ones overflow");
  if (bound == Bound::none) return std::abs(x) < smallest_number ? 0 : x;
  if (x < 0) refuse(field, in_words(bound), "did you mean " + decimal(-x) + "?");
  if (bound == Bound::positive && x == 0) refuse(field, in_words(bound), "0 has no meaning here");
  if (bound == Bound::positive && x < smallest_number)
    refuse(field, "a number of at least 1e-60", "smaller ones underflow");
  if (bound == Bound::fraction && x > 1)
    refuse(field, in_words(bound), "1 is the whole; a colour of 0 to 255 is divided by 255");
  return x;
}

int integer(const Field& field, int least, int most) {
  const std::string expected = "an integer from " + std::to_string(least) + " to " + std::to_string(most);
  const auto* whole = std::get_if<std::int64_t>(&field.value.content);
  if (whole == nullptr) {
    const auto* real = std::get_if<double>(&field.value.content);
    if (real != nullptr) refuse(field, expected, "integers stand without a point or exponent");
    refuse(field, expected, advice_on_type(field.value, "write an integer such as " + std::to_string(least)));
  }
  if (*whole < least) refuse(field, expected, "the least is " + std::to_string(least));
  if (*whole > most) refuse(field, expected, "the most is " + std::to_string(most));
  return static_cast<int>(*whole);
}

const std::string& text(const Field& field) {
  if (const auto* word = std::get_if<std::string>(&field.value.content)) return *word;
  refuse(field, "text", "text stands in quotes, as in " + std::string(field.key) + " = \"...\"");
}

core::Vec3 vector(const Field& field) { return three(field, Bound::none, "[x, y, z]", "[0.0, 0.5, 1.0]"); }

core::Color color(const Field& field, Bound bound) {
  return three(field, bound, "[red, green, blue]", "[1.0, 0.5, 0.0]");
}

const Value::Array& array(const Field& field, std::string_view of, std::string_view advice) {
  if (const auto* elements = std::get_if<Value::Array>(&field.value.content)) return *elements;
  refuse(field, "an array of " + std::string(of), advice);
}

std::vector<core::Vec3> vectors(const Field& field) {
  std::vector<core::Vec3> points;
  for (const Value& element : array(field, "points", "write it as in [[0, 0, 0], [1, 0, 0], ...]"))
    points.push_back(vector({element, field.file, field.table, field.key}));
  return points;
}

void refuse_word(const Field& field, const std::vector<std::string_view>& known) {
  refuse(field, "one of " + listed(known),
         did_you_mean(text(field), known, "the words stand as they are listed"));
}

} // namespace halftone::scene
