#include "run.h"
#include "support/json_keys.h"

#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace halftone;
using nlohmann::json;
using test::run_m508;
using test::Scratch;

TEST_CASE("stats --json prints one object with the documented keys and nothing else") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble(
                         "zeros 5\nclear\nclear\npixels 000000*7\nframe 0x77\nbytes 01 02\nclear\n")));
  const auto outcome = run_m508(scratch, {"stats", "a", "--json"});
  REQUIRE(outcome.exit_code == 0);
  const json stats = json::parse(outcome.out);
  CHECK(test::keys_of(outcome.out) == test::documented("m508 stats"));

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

TEST_CASE("a restart of the device is no reset that a client sent") {
  const Scratch scratch;
  scratch.write("a.txt", ".trace version=1 profile=0 bus=\"b\" byte_picoseconds=0 frame_picoseconds=0\n"
                         "reset\n.restart\nclear\n");
  REQUIRE(run_m508(scratch, {"asm", "a.txt", "-o", "a"}).exit_code == 0);
  const auto outcome = run_m508(scratch, {"stats", "a", "--json"});
  REQUIRE(outcome.exit_code == 0);
  const json stats = json::parse(outcome.out);
  CHECK(stats.at("commands") == 3);
  CHECK(stats.at("opcodes") == json::parse(R"([{"name": "clear", "count": 1, "bytes": 13},
                                               {"name": "reset", "count": 1, "bytes": 13}])"));
  const auto pixels = [&](const std::string& text) {
    scratch.write("b", test::as_text(protocol::assemble(text)));
    return json::parse(run_m508(scratch, {"stats", "b", "--json"}).out).at("pixels");
  };
  CHECK(stats.at("pixels") == pixels("reset\nclear\n"));
}
