#include "program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using halftone::test::Bench;
using halftone::test::Outcome;
using nlohmann::json;

namespace {

Outcome who(const std::string& text, std::vector<std::string> arguments) {
  Bench bench;
  bench.stream("s.raw", text);
  arguments.insert(arguments.begin(), {"who", "s.raw"});
  return bench.m508(arguments);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string red = "fill x=0 y=0 width=20 height=20 red=255 green=0 blue=0\n";

} // namespace

TEST_CASE("who tells the last writer, and those before") {
  const Outcome outcome = who("clear\n" + red, {"3", "4"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "at screen (3, 4) after 2 commands lies image0 (3, 4): 255 0 0\n"
                       "last written by command 2 (byte 13, session 1, sequence 2)\n"
                       "  fill x=0 y=0 width=20 height=20 red=255 green=0 blue=0\n"
                       "  0 0 0 -> 255 0 0\n"
                       "other commands that addressed it, newest first\n"
                       "  command 1 (byte 0, session 1, sequence 1)\n"
                       "    clear\n"
                       "    0 0 0 -> 0 0 0\n");
}

TEST_CASE("who exits with 1 where nobody wrote") {
  const Outcome outcome = who(red, {"100", "100"});
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.out, "no command has written it\n"));
}

TEST_CASE("who maps the screen through shown buffer, pan and zoom") {
  const Outcome outcome =
      who("buffers written=1 shown=1\npan x=500 y=2\nzoom shift=2\n" + red, {"53", "9", "--json"});
  CHECK(outcome.exit_code == 0);
  const json answer = json::parse(outcome.out);
  CHECK(answer.at("plane") == "image1");
  CHECK(answer.at("x") == (500 + 53 / 4) % 512);
  CHECK(answer.at("y") == 2 + 9 / 4);
  CHECK(answer.at("last").at("number") == 4);
}

TEST_CASE("who says what is seen instead of the image") {
  CHECK(contains(who(red + "blank on=1\n", {"1", "1"}).out, "but the screen is blank: 0 0 0 is seen\n"));
  CHECK(contains(who(red + "border thickness=2 red=1 green=2 blue=3\n", {"1", "1"}).out,
                 "but the border covers it: 1 2 3 is seen\n"));
  CHECK(contains(
      who(red + "cursor_pattern ff*32\ncursor x=0 y=0 on=1 blink=0 red=4 green=5 blue=6\n", {"1", "1"}).out,
      "but the cursor covers it: 4 5 6 is seen\n"));
  const std::string overlay =
      red + "overlay on=1 blink=0 red=7 green=8 blue=9\noverlay_fill x=0 y=0 width=3 height=3 value=1\n";
  CHECK(contains(who(overlay, {"1", "1"}).out, "but the overlay covers it: 7 8 9 is seen; ask who wrote that "
                                               "with --plane overlay 1 1\n"));
  CHECK(contains(who(overlay, {"1", "1", "--plane", "overlay"}).out, "overlay (1, 1) after 3 commands: 1\n"));
  CHECK(contains(who(red + "read_mask red=240 green=0 blue=0\nlut channels=1 first=240 07\n", {"1", "1"}).out,
                 "but the read mask leaves 240 0 0, of which the look-up tables make 7 0 0\n"));
}

TEST_CASE("who cuts a long history off, and tells all of it if asked") {
  std::string text;
  for (int i = 0; i < 12; ++i) text += red;
  CHECK(contains(who(text, {"1", "1"}).out, "and 6 more before (--all)\n"));
  const Outcome all = who(text, {"1", "1", "--all", "--json"});
  CHECK(json::parse(all.out).at("history").size() == 12);
}

TEST_CASE("who looks no farther than it is told") {
  CHECK(contains(who("clear\n" + red, {"1", "1", "--until", "1"}).out,
                 "after 1 command lies image0 (1, 1): 0 0 0"));
  const std::string marked = "clear\nmark \"red\"\n" + red;
  CHECK(contains(who(marked, {"1", "1", "--until", "mark:red"}).out,
                 "after 2 commands lies image0 (1, 1): 0 0 0"));
  const Outcome never = who(marked, {"1", "1", "--until", "4"});
  CHECK(never.exit_code == 2);
  CHECK(never.err == "m508: --until 4: the recording ends before, after command 3\n");
}

TEST_CASE("who --json prints the documented keys") {
  const Outcome outcome = who(red, {"1", "1", "--json"});
  CHECK(halftone::test::keys_of(outcome.out) == halftone::test::documented("m508 who"));
}

TEST_CASE("who refuses coordinates off the screen, unknown planes and files that are not there") {
  CHECK(who(red, {"512", "1"}).exit_code == 2);
  CHECK(who(red, {"1", "1", "--plane", "image2"}).exit_code == 2);
  CHECK(Bench().m508({"who", "missing.raw", "1", "1"}).exit_code == 3);
}
