#include "run.h"

#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace halftone;
using test::run_m508;
using test::Scratch;

TEST_CASE("the table in framebuffer/buses.toml is the built-in one") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble("clear\npixels 000000*100\n")));
  const auto built_in = run_m508(scratch, {"stats", "a", "--json"});
  CHECK(built_in.exit_code == 0);
  CHECK(built_in.out ==
        run_m508(scratch, {"stats", "a", "--json", "--buses", HALFTONE_SOURCE_DIR "/framebuffer/buses.toml"})
            .out);
}

TEST_CASE("a table of one's own gives its buses their times") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble("mark \"x\"\n")));
  scratch.write("b.toml", "[[bus]]\nname = \"slow\"\nbytes_per_second = 2\nmicroseconds_per_command = 1e6\n");
  const auto outcome = run_m508(scratch, {"stats", "a", "--json", "--buses", "b.toml"});
  REQUIRE(outcome.exit_code == 0);
  const auto buses = nlohmann::json::parse(outcome.out).at("buses");
  REQUIRE(buses.size() == 1);
  CHECK(buses[0].at("name") == "slow");
  CHECK(buses[0].at("seconds").get<double>() == Approx(7 + 1 + 10e-6)); // 14 bytes
}

TEST_CASE("a table that is wrong is refused with its place") {
  struct Malformed {
    std::string toml;
    std::string message;
  };
  std::string deep; // which toml++ alone sets no bound to, and takes apart recursively
  for (int i = 0; i < 30'000; ++i) deep += ".a";
  const Malformed cases[] = {
      {"", "b.toml: has no [[bus]]"},
      {"[[bus]]\nname = 3", "b.toml:1:1: a bus needs a name in quotes"},
      {"[[bus]]\nname = \"\"", "b.toml:1:1: a bus needs a name in quotes"},
      {"[[bus]]\nname = \"a\"\nbytes_per_second = 0",
       "b.toml:3:20: bytes_per_second: expected a number from 1 to"},
      {"[[bus]]\nname = \"a\"\nbytes_per_second = nan", "b.toml:3:20: bytes_per_second: expected a number"},
      {"[[bus]]\nname = \"a\"\nbytes_per_second = \"1\"", "b.toml:3:20: bytes_per_second: expected a number"},
      {"[[bus]]\nname = \"a\"\nmicroseconds_per_command = -1",
       "b.toml:3:28: microseconds_per_command: expected a"},
      {"[[bus]]\nname = \"a\"\n[[bus]]\nname = \"a\"", "b.toml:3:1: there is a second bus \"a\""},
      {"[bus]\nname = \"a\"", "b.toml:1:1: expected [[bus]] and nothing else"},
      {"speed = 3", "b.toml:1:1: unknown key \"speed\" in the file; the keys are bus"},
      {std::string(1, 'a') + deep + " = 1", "b.toml:1:514: a line with more than 256 dots; no key of this"},
      {"[[bus]\nname", "b.toml:1:"},
      {std::string(70'000, '#'), "b.toml: is too long for a table of buses"},
  };
  const Scratch scratch;
  scratch.write("a", "");
  for (const Malformed& malformed : cases) {
    scratch.write("b.toml", malformed.toml);
    const auto outcome = run_m508(scratch, {"stats", "a", "--buses", "b.toml"});
    INFO(malformed.toml.substr(0, 200) << "\n" << outcome.err);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.err.starts_with("m508: " + malformed.message));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}
