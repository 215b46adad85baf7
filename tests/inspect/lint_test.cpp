#include "streams.h"

#include <halftone/inspect/lint.h>
#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace halftone;
using inspect::Finding;

namespace {

std::vector<Finding> lint(const std::string& text) { return inspect::lint(test::trace_of_text(text)); }

/// As in "3 redundant, 4 wraps".
std::string brief(const std::string& text) {
  std::string result;
  for (const Finding& finding : lint(text))
    result += (result.empty() ? "" : ", ") + std::to_string(finding.command.number) + ' ' +
              std::string(inspect::entry_of(finding.kind).name);
  return result;
}

} // namespace

TEST_CASE("the kinds are listed in their order") {
  for (std::size_t i = 0; i < inspect::kind_table.size(); ++i)
    CHECK(static_cast<std::size_t>(inspect::kind_table[i].kind) == i);
}

TEST_CASE("a stream that makes sense has no findings") {
  CHECK(brief("reset\nwindow x=10 y=10 width=4 height=2\npixels 112233*8\nstatus\n") == "");
  CHECK(brief("") == "");
}

TEST_CASE("refused commands are findings that say what would have been taken") {
  const auto findings = lint("frame 0x7f 01\nframe 0x10 00 00\nframe 0x34 09\nbytes 6a 75 6e 6b\nstatus\n");
  REQUIRE(findings.size() == 4);
  CHECK(findings[0].command.text == "0x7f, unknown opcode");
  CHECK(findings[1].command.text == "window, wrong length");
  CHECK(findings[1].advice == "window takes x 2 bytes, y 2 bytes, width 2 bytes, height 2 bytes");
  CHECK(findings[2].command.text == "zoom, out of limits");
  CHECK(findings[2].advice == "zoom takes shift 0 to 3");
  CHECK(findings[3].command.text == "4 damaged bytes");
  for (const Finding& finding : findings) {
    CHECK(finding.kind == inspect::Kind::rejected);
    CHECK_FALSE(finding.what.empty());
  }
}

TEST_CASE("writes under a write mask without bits are findings, and those that it is not for are none") {
  CHECK(brief("write_mask red=0 green=0 blue=0\npixels 010203\n") == "2 masked-out");
  CHECK(brief("write_mask red=0 green=1 blue=0\npixels 010203\n") == "");
  CHECK(brief("write_mask red=0 green=0 blue=0\nfill x=0 y=0 width=1 height=1 red=1 green=1 blue=1\n"
              "overlay_fill x=0 y=0 width=1 height=1 value=1\n") == "2 masked-out");
}

TEST_CASE("work that is wholly overwritten before a field has shown it is a finding") {
  const std::string twice = "fill x=0 y=0 width=8 height=8 red=1 green=1 blue=1\n";
  const std::string other = "fill x=0 y=0 width=8 height=8 red=2 green=2 blue=2\n";
  CHECK(brief(twice + other) == "1 never-seen");
  CHECK(brief(twice + "wait fields=1\n" + other) == "");
  CHECK(brief(twice + "read_screen x=0 y=0 width=1 height=1\n" + other) == "");
  CHECK(brief(twice + "checksum x=0 y=0 width=8 height=8\n" + other) == "");
  CHECK(brief(twice + "checksum x=0 y=0 width=8 height=7\n" + other) == "1 partly-unseen");
  CHECK(brief(twice + "copy x=0 y=0 width=8 height=8 to_x=100 to_y=0 from=0\n" + other) == "");
  CHECK(brief(twice + "buffers written=0 shown=1\n" + other) == ""); // it was on the screen until then
}

TEST_CASE("a field that ends during a command shows what was there before, and what it has written") {
  // A fill of all pixels takes 13.1 ms of a field's 16.7, so that a field ends during the second.
  const auto fill = [](int level) {
    return "fill x=0 y=0 width=512 height=512 red=" + std::to_string(level) + " green=0 blue=0\n";
  };
  const std::string small = "fill x=0 y=0 width=8 height=8 red=9 green=9 blue=9\n";
  CHECK(brief(fill(1) + fill(2) + small) == "");
  CHECK(brief(fill(1) + small + fill(2) + small) == "1 partly-unseen");
}

TEST_CASE("work in the buffer that is not shown waits for the swap, not for fields") {
  const std::string begin = "buffers written=1 shown=0\n";
  const std::string first = "fill x=0 y=0 width=8 height=8 red=1 green=1 blue=1\n";
  const std::string other = "fill x=0 y=0 width=8 height=8 red=2 green=2 blue=2\n";
  CHECK(brief(begin + first + "wait fields=5\n" + other) == "2 never-seen");
  CHECK(brief(begin + first + "buffers written=1 shown=1\nbuffers written=1 shown=0\n" + other) == "");
}

TEST_CASE("work is not seen while the screen is blank, or where zoom leaves it out") {
  const std::string first = "fill x=300 y=300 width=8 height=8 red=1 green=1 blue=1\n";
  const std::string other = "fill x=300 y=300 width=8 height=8 red=2 green=2 blue=2\n";
  CHECK(brief("blank on=1\n" + first + "wait fields=1\n" + other) == "2 never-seen");
  CHECK(brief("zoom shift=1\n" + first + "wait fields=1\n" + other) == "2 never-seen");
  CHECK(brief("zoom shift=1\npan x=500 y=400\n" + first + "wait fields=1\n" + other) == "3 never-seen");
  CHECK(brief("zoom shift=1\npan x=100 y=400\n" + first + "wait fields=1\n" + other) == "3 never-seen");
  CHECK(brief("zoom shift=1\npan x=100 y=200\n" + first + "wait fields=1\n" + other) == "");
}

TEST_CASE("work that is partly overwritten is a note, unless it only erases") {
  CHECK(
      brief("fill x=0 y=0 width=8 height=8 red=1 green=1 blue=1\nfill x=0 y=0 width=2 height=2 red=2 green=2 "
            "blue=2\n") == "1 partly-unseen");
  CHECK(brief("buffers written=1 shown=0\nfill x=0 y=0 width=9 height=9 red=1 green=1 blue=1\nbuffers "
              "written=1 shown=1\nbuffers written=1 shown=0\nclear\nfill x=0 y=0 width=2 height=2 red=2 "
              "green=2 blue=2\n") == "");
}

TEST_CASE("writes of single channels one after the other lose nothing") {
  CHECK(brief("write_mask red=255 green=0 blue=0\nfill x=0 y=0 width=8 height=8 red=1 green=0 blue=0\n"
              "write_mask red=0 green=255 blue=0\nfill x=0 y=0 width=8 height=8 red=0 green=2 blue=0\n") ==
        "");
}

TEST_CASE("pixels beyond the end of the window are findings, those up to it are none") {
  const std::string window = "window x=5 y=5 width=2 height=2\n";
  CHECK(brief(window + "pixels 010203*4\n") == "");
  CHECK(brief(window + "pixels 010203*3\npixels 030201\n") == "");
  CHECK(brief(window + "repeat count=5 red=1 green=2 blue=3\n") == "2 wraps");
  CHECK(brief(window + "pixels 010203*3\nruns 01040506\n") == "2 partly-unseen, 3 wraps");
  CHECK(lint(window + "pixels 010203*3\nruns 02040506\n").back().what ==
        "2 pixels of 3 beyond the end of the window, which go on at its beginning");
}

TEST_CASE("rectangles that lie partly in the window are findings, those wholly in or out are none") {
  const std::string window = "window x=10 y=10 width=10 height=10\npixels 010203\n";
  const auto fill = [](const std::string& rectangle) {
    return "fill " + rectangle + " red=9 green=9 blue=9\n";
  };
  CHECK(brief(window + fill("x=11 y=11 width=5 height=5")) == "");
  CHECK(brief(window + fill("x=50 y=50 width=5 height=5")) == "");
  CHECK(brief(window + fill("x=18 y=18 width=5 height=2")) == "3 outside-window");
  CHECK(brief(window + "copy x=100 y=100 width=5 height=5 to_x=18 to_y=11 from=0\n") ==
        "3 outside-window, 3 redundant");
}

TEST_CASE("a window into which nothing is written is a finding") {
  const std::string window = "window x=0 y=0 width=2 height=2\n";
  CHECK(brief(window + window + "pixels 010203\n") == "1 window-unused, 2 redundant");
  CHECK(brief(window + "reset\n") == "1 window-unused");
  CHECK(brief(window + "fill x=0 y=0 width=1 height=1 red=1 green=1 blue=1\n") == "1 window-unused");
  CHECK(brief(window + "repeat count=1 red=1 green=1 blue=1\n") == "");
}

TEST_CASE("commands that change nothing are notes, but for those that are worth it") {
  CHECK(brief("zoom shift=1\nzoom shift=1\n") == "2 redundant");
  CHECK(brief("clear\n") == "1 redundant");
  CHECK(brief("reset\nreset\nwait fields=1\nmark \"x\"\nstatus\nidentify\n") == "");
  CHECK(brief("lut channels=1 first=3 03\n") == "1 redundant");
  CHECK(brief("overlay_bits x8=1 y=1 00\n") == "1 redundant");
  CHECK(inspect::entry_of(lint("clear\n").at(0).kind).severity == inspect::Severity::note);
}

TEST_CASE("what a restart of the device makes in vain is blamed on no client") {
  const recording::Data work{protocol::assemble("repeat count=1 red=1 green=1 blue=1\n"
                                                "overlay_fill x=0 y=0 width=1 height=1 value=1\n"
                                                "window x=0 y=0 width=2 height=2\n")};
  recording::Trace trace;
  trace.records = {recording::SessionBegin{"one"}, work, recording::SessionEnd{"the device restarts"},
                   recording::Restart{}};
  CHECK(inspect::lint(trace).empty());
  trace.records.back() = recording::Data{protocol::assemble("reset\n")};
  CHECK_FALSE(inspect::lint(trace).empty());
}

TEST_CASE("findings are sorted by command") {
  for (std::uint64_t seed = 400; seed < 500; ++seed) {
    test::Random random(seed);
    const auto findings = inspect::lint(test::trace_of(test::damaged(random, test::random_stream(random))));
    for (std::size_t i = 1; i < findings.size(); ++i)
      REQUIRE(findings[i - 1].command.number <= findings[i].command.number);
    for (const Finding& finding : findings) {
      INFO("seed " << seed << ", command " << finding.command.number);
      REQUIRE_FALSE(finding.command.text.empty());
      REQUIRE_FALSE(finding.what.empty());
      REQUIRE_FALSE(finding.advice.empty());
    }
  }
}
