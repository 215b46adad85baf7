#include "run.h"

#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

using namespace halftone;
using nlohmann::json;
using test::run_m508;
using test::Scratch;

namespace {

/// Keys as docs/json.md writes them: buses[].name for one of the objects of an array.
void collect(const json& value, const std::string& path, std::set<std::string>& keys) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items())
      collect(inner, path.empty() ? key : path + "." + key, keys);
  } else if (value.is_array()) {
    for (const json& inner : value) collect(inner, path + "[]", keys);
  } else {
    keys.insert(path);
  }
}

/// The first column of the table under the heading.
std::set<std::string> documented(const std::string& heading) {
  std::istringstream page(test::contents(HALFTONE_SOURCE_DIR "/docs/json.md"));
  std::set<std::string> keys;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) inside = line == "## " + heading;
    if (inside && line.starts_with("| `")) keys.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

} // namespace

TEST_CASE("stats --json prints one object with the documented keys and nothing else") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble(
                         "zeros 5\nclear\nclear\npixels 000000*7\nframe 0x77\nbytes 01 02\nclear\n")));
  const auto outcome = run_m508(scratch, {"stats", "a", "--json"});
  REQUIRE(outcome.exit_code == 0);
  const json stats = json::parse(outcome.out);
  std::set<std::string> keys;
  collect(stats, "", keys);
  CHECK(keys == documented("m508 stats"));

  CHECK(stats.at("commands") == 6);
  CHECK(stats.at("rejected") == 2);
  CHECK(stats.at("sessions") == 1);
  CHECK(stats.at("bytes") == 5 + 4 * 13 + 34 + 2);
  CHECK(stats.at("fill") == 5);
  CHECK(stats.at("pixels") == 7);
  CHECK(stats.at("opcodes").at(0) == json{{"name", "clear"}, {"count", 3}, {"bytes", 39}});
  CHECK(stats.at("errors").at(0) == json{{"name", "damaged"}, {"count", 1}, {"bytes", 2}});
  CHECK(stats.at("buses").size() == 5);
}

TEST_CASE("stats tells people the same") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble("clear\nclear\n")));
  const auto outcome = run_m508(scratch, {"stats", "a"});
  CHECK(outcome.exit_code == 0);
  for (const char* word : {"commands", "clear", "26 bytes", "rs232", "unlimited"}) {
    INFO(word);
    CHECK(outcome.out.find(word) != std::string::npos);
  }
}
