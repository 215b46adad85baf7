#include "program.h"

#include <halftone/protocol/text.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace halftone::test {

namespace {

using nlohmann::json;

/// rays.eye for a key of a nested object, lights[].color for one of the objects of an array.
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

void Bench::stream(const std::string& name, const std::string& text) const {
  const auto bytes = protocol::assemble(text);
  scratch.write(name, {bytes.begin(), bytes.end()});
}

Outcome Bench::m508(const std::vector<std::string>& arguments) const {
  return run_halftone(arguments, {.folder = scratch.path()});
}

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
