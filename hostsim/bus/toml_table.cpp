#include <halftone/bus/toml_table.h>

#include <halftone/core/error.h>

#include <algorithm>
#include <cmath>

namespace halftone::bus {

namespace {

core::Place place_of(const std::string& file, const toml::source_region& region) {
  return {file, std::max(static_cast<int>(region.begin.line), 1),
          std::max(static_cast<int>(region.begin.column), 1)};
}

/// toml++ destroys tables recursively and sets no bound to the parts of a dotted key: a line of some 30,000
/// "a.a.a" overflows the stack.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  constexpr int most_dots = 256;
  core::Place place{file, 1, 1};
  int dots = 0;
  for (const char c : text) {
    if (c == '.' && ++dots > most_dots)
      throw core::InputError(place, "a line with more than " + std::to_string(most_dots) + " dots",
                             "no key of this file needs one");
    if (c == '\n') {
      place = {file, place.line + 1, 1};
      dots = 0;
    } else {
      ++place.column;
    }
  }
}

std::string kind_of(const toml::node& node) {
  if (node.is_string()) return "text";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a number with a point";
  if (node.is_boolean()) return "true or false";
  if (node.is_array()) return "an array";
  return node.is_table() ? "a table" : "a date or time";
}

} // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  refuse_deep_keys(text, file);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::string problem = "not valid TOML: " + std::string(error.description());
    std::ranges::replace_if(
        problem, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    throw core::InputError(place_of(file, error.source()), problem,
                           "the format is TOML 1.0, see https://toml.io; text needs \"quotes\"");
  }
}

void fail(const std::string& file, const toml::node& at, const std::string& problem,
          const std::string& advice) {
  throw core::InputError(place_of(file, at.source()), problem, advice);
}

std::uint32_t integer(const std::string& file, const toml::node& node, const std::string& what,
                      std::uint32_t least, std::uint32_t most) {
  const std::string expected =
      what + ": expected an integer from " + std::to_string(least) + " to " + std::to_string(most);
  const auto* value = node.as_integer();
  if (value == nullptr) fail(file, node, expected + ", found " + kind_of(node));
  if (value->get() < least || value->get() > most)
    fail(file, node, expected + ", found " + std::to_string(value->get()));
  return static_cast<std::uint32_t>(value->get());
}

std::vector<std::uint32_t> integers(const std::string& file, const toml::node& node, const std::string& what,
                                    const std::vector<std::uint32_t>& least,
                                    const std::vector<std::uint32_t>& most) {
  const auto* array = node.as_array();
  const std::string expected = what + ": expected an array of " + std::to_string(least.size()) + " integers";
  if (array == nullptr) fail(file, node, expected + ", found " + kind_of(node));
  if (array->size() != least.size()) fail(file, node, expected + ", found " + std::to_string(array->size()));
  std::vector<std::uint32_t> values;
  for (std::size_t i = 0; i < least.size(); ++i)
    values.push_back(integer(file, *array->get(i), what, least[i], most[i]));
  return values;
}

double number(const std::string& file, const toml::node& node, const std::string& what, double least,
              double most) {
  const auto value = node.value<double>();
  const bool is_number =
      node.is_number() && value && std::isfinite(*value) && *value >= least && *value <= most;
  if (!is_number)
    fail(file, node,
         what + ": expected a number from " + std::to_string(static_cast<long long>(least)) + " to " +
             std::to_string(static_cast<long long>(most)));
  return *value;
}

std::string text(const std::string& file, const toml::node& node, const std::string& what) {
  const auto* value = node.as_string();
  if (value == nullptr) fail(file, node, what + ": expected text in quotes, found " + kind_of(node));
  return value->get();
}

void require_known_keys(const std::string& file, const toml::table& table, const std::string& what,
                        const std::vector<std::string_view>& known) {
  const toml::key* unknown = nullptr; // toml++ sorts by name: the first in the file is to be told
  for (const auto& [key, value] : table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    const bool is_earlier = unknown == nullptr || key.source().begin.line < unknown->source().begin.line;
    if (is_earlier) unknown = &key;
  }
  if (unknown == nullptr) return;
  std::string names;
  for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
  throw core::InputError(place_of(file, unknown->source()),
                         "unknown key \"" + std::string(unknown->str()) + "\" in " + what,
                         "the keys are " + names);
}

} // namespace halftone::bus
