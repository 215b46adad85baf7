#include "json_keys.h"

#include "scratch.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace halftone::test {

namespace {

using nlohmann::json;

void collect(const json& value, const std::string& path, std::set<std::string>& keys) {
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, inner] : value.items())
      collect(inner, path.empty() ? key : path + "." + key, keys);
  } else if (value.is_array() && !value.empty() && value.front().is_object()) {
    for (const json& inner : value) collect(inner, path + "[]", keys);
  } else {
    keys.insert(path);
  }
}

} // namespace

std::set<std::string> keys_of(const std::string& text) {
  std::set<std::string> keys;
  collect(json::parse(text), "", keys);
  return keys;
}

std::set<std::string> documented(const std::string& heading) {
  std::istringstream page(contents(HALFTONE_SOURCE_DIR "/docs/json.md"));
  std::set<std::string> keys;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) inside = line == "## " + heading;
    if (inside && line.starts_with("| `")) keys.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

} // namespace halftone::test
