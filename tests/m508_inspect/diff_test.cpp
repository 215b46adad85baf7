#include "program.h"

#include <catch2/catch.hpp>

using halftone::test::Bench;
using halftone::test::Outcome;

namespace {

struct Pair : Bench {
  Pair(const std::string& a, const std::string& b) {
    stream("a.raw", a);
    stream("b.raw", b);
  }
};

} // namespace

TEST_CASE("diff tells the commands and the first pixel") {
  const Pair pair("clear\nfill x=1 y=2 width=3 height=4 red=9 green=9 blue=9\n",
                  "status\nclear\nfill x=1 y=2 width=3 height=4 red=9 green=9 blue=8\n");
  const Outcome outcome = pair.m508({"diff", "a.raw", "b.raw", "--ignore-clock"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out == "the states differ for the first time after\n"
                       "  A  a.raw: command 2 (byte 13, session 1, sequence 2)\n"
                       "     fill x=1 y=2 width=3 height=4 red=9 green=9 blue=9\n"
                       "  B  b.raw: command 3 (byte 26, session 1, sequence 3)\n"
                       "     fill x=1 y=2 width=3 height=4 red=9 green=9 blue=8\n"
                       "pixel (1, 2) of image0: A 9 9 9, B 9 9 8; it is the first of 12 pixels that differ, "
                       "within 3 x 4 at (1, 2)\n");
  const Outcome json = pair.m508({"diff", "a.raw", "b.raw", "--ignore-clock", "--json"});
  CHECK(json.exit_code == 1);
}

TEST_CASE("diff exits with 0 where nothing differs") {
  const Pair pair("clear\n", "clear\n");
  const Outcome outcome = pair.m508({"diff", "a.raw", "b.raw"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "the states do not differ after any command\n");
}

TEST_CASE("diff tells registers, tables, the clock and the end of a recording") {
  const Outcome outcome =
      Pair("zoom shift=1\nlut channels=1 first=3 07 08\n", "zoom shift=1\n").m508({"diff", "a.raw", "b.raw"});
  CHECK(outcome.out.find("  B  b.raw: its end\n") != std::string::npos);
  CHECK(outcome.out.find("entry 3 of the look-up table of red: A 7, B 3; it is the first of 2 entries that "
                         "differ\n") != std::string::npos);
  CHECK(outcome.out.find("(--ignore-clock leaves it out)") != std::string::npos);
  CHECK(Pair("zoom shift=1\n", "zoom shift=2\n")
            .m508({"diff", "a.raw", "b.raw"})
            .out.find("register zoom: A 1, B 2\n") != std::string::npos);
}

TEST_CASE("diff --json prints the documented keys, all of them if all kinds differ") {
  const Pair pair("lut channels=1 first=3 09\n",
                  "clear\nfill x=0 y=0 width=1 height=1 red=1 green=1 blue=1\n");
  auto keys = halftone::test::keys_of(pair.m508({"diff", "a.raw", "b.raw", "--json"}).out);
  const Pair pixels("fill x=0 y=0 width=1 height=1 red=1 green=1 blue=1\n", "zoom shift=2\n");
  keys.merge(halftone::test::keys_of(pixels.m508({"diff", "a.raw", "b.raw", "--json"}).out));
  CHECK(keys == halftone::test::documented("m508 diff"));
}

TEST_CASE("diff tells of a recording that does not come to its own states, where that begins") {
  const Pair pair("clear\n", "clear\n");
  const std::string head = ".trace version=1 profile=0 bus=\"b\" byte_picoseconds=0 frame_picoseconds=0\n"
                           "clear\n.state commands=1 checksum=1842471015\n";
  pair.file("good.txt", head);
  pair.file("bad.txt", head + "clear\n.state commands=2 checksum=7\n");
  for (const std::string name : {"good", "bad"})
    REQUIRE(pair.m508({"asm", name + ".txt", "-o", name + ".m508"}).exit_code == 0);
  CHECK(pair.m508({"diff", "good.m508", "good.m508"}).exit_code == 0);
  const std::string problem =
      "m508: bad.m508: after command 2 this device has state 6dd1e067, and the recorded "
      "one had state 00000007 after command 2; they last agreed after command 1\n";
  const Outcome outcome = pair.m508({"diff", "bad.m508", "bad.m508"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out == "the states do not differ after any command\n");
  CHECK(outcome.err == problem + problem);
}
