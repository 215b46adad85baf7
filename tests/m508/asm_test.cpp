#include "../recording/random_trace.h"
#include "run.h"

#include <halftone/protocol/text.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

using namespace halftone;
using test::run_m508;
using test::Scratch;

TEST_CASE("asm makes of what disasm wrote the same file, be it a recording or a raw stream") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    test::Random random(seed);
    const Scratch scratch;
    const auto bytes = seed % 2 == 0 ? encode(test::random_trace(random))
                                     : test::random_stream(random, protocol::Direction::to_device);
    scratch.write("a", test::as_text(bytes));
    INFO("seed " << seed);
    const auto taken_apart = run_m508(scratch, {"disasm", "a", "-o", "a.txt"});
    REQUIRE(taken_apart.exit_code == 0);
    CHECK(taken_apart.out.empty());
    CHECK(run_m508(scratch, {"disasm", "a"}).out == test::contents(scratch / "a.txt"));
    REQUIRE(run_m508(scratch, {"asm", "a.txt", "-o", "b"}).exit_code == 0);
    REQUIRE(test::contents(scratch / "b") == test::as_text(bytes));
  }
}

TEST_CASE("disasm names replies if it is told that they are") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble("#3 sum checksum=7")));
  CHECK(run_m508(scratch, {"disasm", "a"}).out == "#3 frame 0xa1 00*3 07 ; unknown opcode\n");
  CHECK(run_m508(scratch, {"disasm", "a", "--replies"}).out == "#3 sum checksum=7\n");
}

TEST_CASE("a recording that was cut off is taken apart, and stderr says so") {
  const Scratch scratch;
  recording::Trace trace;
  trace.cut_off = {1, 0};
  scratch.write("a", test::as_text(encode(trace)));
  const auto outcome = run_m508(scratch, {"disasm", "a"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.ends_with(".cut_off 0100\n"));
  CHECK(outcome.err == "m508: a: the last record is cut off after 2 bytes, and left out\n");
}
