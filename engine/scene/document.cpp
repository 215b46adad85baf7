#include "document.h"

#include <halftone/core/error.h>

#include <algorithm>
#include <cctype>
#include <toml++/toml.h>

namespace halftone::scene {

namespace {

/// toml++ bounds the nesting of values at 256, but not that of dotted keys, and destroys tables recursively:
/// a line of some 30,000 "a.a.a" overflows the stack. With this bound on one key its depth stays below
/// 17,000.
constexpr int most_dots = 64;

Position position_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

bool is_key_end(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '"' || c == '\'';
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Where the string or comment that begins at `start` ends: after its last character, or where the line or
/// the text ends that cuts it off.
std::size_t end_of_text(std::string_view text, std::size_t start) {
  const char quote = text[start];
  if (quote == '#') return std::min(text.find('\n', start), text.size());
  const std::string_view mark = text.substr(start, 3);
  const bool is_long = mark == "\"\"\"" || mark == "'\'\'";
  for (std::size_t i = start + (is_long ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (is_long && text.substr(i, 3) == mark)
      return i + 3;
    else if (!is_long && text[i] == quote)
      return i + 1;
    else if (!is_long && text[i] == '\n')
      return i;
  }
  return text.size();
}

Position position_in(std::string_view text, std::size_t index) {
  const std::string_view before = text.substr(0, index);
  const std::size_t line_start = before.rfind('\n') + 1; // 0 where there is none before
  const auto begins_character = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }; // in UTF-8
  return {static_cast<int>(1 + std::count(before.begin(), before.end(), '\n')),
          static_cast<int>(1 + std::count_if(before.begin() + line_start, before.end(), begins_character))};
}

/// Counts the dots that may join the parts of one key.
void refuse_deep_keys(std::string_view text, const std::string& name) {
  int dots = 0;
  char before = '\n';
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '.' && is_key_end(before) && ++dots > most_dots) {
      const Position position = position_in(text, i);
      throw core::InputError({name, position.line, position.column},
                             "a dotted key of more than " + std::to_string(most_dots) + " parts",
                             "the format nests three tables at most, as in material.glass.checker");
    }
    if (std::string_view(",=[]{}\n").find(c) != std::string_view::npos) dots = 0;
    if (!is_blank(c)) before = c;
    i = c == '"' || c == '\'' || c == '#' ? end_of_text(text, i) : i + 1;
  }
}

Value converted(const toml::node& node);

Value::Members members_of(const toml::table& table) {
  Value::Members members;
  members.reserve(table.size());
  for (const auto& [key, node] : table)
    members.push_back({std::string(key.str()), position_of(key.source()), converted(node)});
  // toml++ sorts by name.
  std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return a.position.line != b.position.line ? a.position.line < b.position.line
                                              : a.position.column < b.position.column;
  });
  return members;
}

Value converted(const toml::node& node) {
  Value value{position_of(node.source()), Value::DateOrTime{}};
  if (const auto* boolean = node.as_boolean()) value.content = boolean->get();
  if (const auto* integer = node.as_integer()) value.content = integer->get();
  if (const auto* number = node.as_floating_point()) value.content = number->get();
  if (const auto* text = node.as_string()) value.content = text->get();
  if (const auto* table = node.as_table()) value.content = members_of(*table);
  if (const auto* array = node.as_array()) {
    Value::Array elements;
    elements.reserve(array->size());
    for (const toml::node& element : *array) elements.push_back(converted(element));
    value.content = std::move(elements);
  }
  return value;
}

/// What to do about the parser's most frequent complaints.
std::string advice_on(std::string_view complaint) {
  const auto says = [&](std::string_view words) { return complaint.find(words) != std::string_view::npos; };
  if (says("redefine") && says("table header"))
    return "each [table] may stand once, and each material needs its own name";
  if (says("redefine")) return "each key may stand once in its table";
  if (says("end-of-file")) return "the file ends inside a value, a string, a bracket or a key";
  if (says("could not determine value type")) return "text needs \"quotes\", and so do names of materials";
  if (says("could not be interpreted")) return "numbers go up to 1e60";
  if (says("not representable"))
    return "whole numbers this long need a decimal point, and numbers go up to 1e60";
  if (says("boolean")) return "text needs \"quotes\"";
  if (says("utf-8")) return "save the file as UTF-8";
  return "the format is TOML 1.0, see https://toml.io";
}

core::InputError syntax_error(const toml::parse_error& error, const std::string& name) {
  constexpr std::string_view opening = "Error while parsing ";
  std::string_view complaint = error.description();
  if (complaint.starts_with(opening)) complaint.remove_prefix(opening.size());
  std::string problem = "not valid TOML: " + std::string(complaint);
  std::replace_if(
      problem.begin(), problem.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; },
      ' ');
  const Position position = position_of(error.source());
  return {{name, std::max(position.line, 1), std::max(position.column, 1)}, problem, advice_on(complaint)};
}

} // namespace

Value parse_document(std::string_view text, const std::string& name) {
  refuse_deep_keys(text, name);
  try {
    const toml::table root = toml::parse(text);
    return {{}, members_of(root)};
  } catch (const toml::parse_error& error) {
    throw syntax_error(error, name);
  }
}

} // namespace halftone::scene
