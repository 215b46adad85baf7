#include "program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using halftone::test::Bench;
using halftone::test::Outcome;

TEST_CASE("lint prints a line for each finding and sums up") {
  Bench bench;
  bench.stream("s.raw",
               "reset\nzoom shift=0\nwindow x=0 y=0 width=2 height=2\npixels 010203*5\nframe 0x34 09\n");
  const Outcome outcome = bench.m508({"lint", "s.raw"});
  CHECK(outcome.exit_code == 1);
  CHECK(
      outcome.out ==
      "s.raw: command 2: note: zoom shift=0: changes nothing: everything is set like this already; leave it "
      "out [redundant]\n"
      "s.raw: command 4: warning: pixels 010203*5: 1 pixel of 5 beyond the end of the window, which go on at "
      "its beginning; the window 2 x 2 at (0, 0) had room for 4 more [wraps]\n"
      "s.raw: command 5: warning: zoom, out of limits: an operand is outside of its limits; zoom takes shift "
      "0 to 3 [rejected]\n"
      "2 warnings, 1 note: 1 rejected, 1 wraps, 1 redundant\n");
  const Outcome json = bench.m508({"lint", "s.raw", "--json"});
  CHECK(json.exit_code == 1);
  CHECK(halftone::test::keys_of(json.out) == halftone::test::documented("m508 lint"));
  CHECK(nlohmann::json::parse(json.out).at("warnings") == 2);
}

TEST_CASE("lint exits with 0 where there are notes alone, or nothing") {
  Bench bench;
  bench.stream("s.raw", "zoom shift=0\n");
  CHECK(bench.m508({"lint", "s.raw"}).exit_code == 0);
  bench.stream("t.raw", "zoom shift=1\n");
  const Outcome outcome = bench.m508({"lint", "t.raw"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "no findings\n");
}
