#include "streams.h"

#include <halftone/inspect/check.h>

#include <halftone/protocol/checksum.h>

#include <catch2/catch.hpp>

using namespace halftone;
using inspect::Check;
using inspect::Surface;
using inspect::Verdict;

namespace {

const char* const stream = "reset\n"
                           "fill x=10 y=20 width=4 height=3 red=1 green=2 blue=3\n"
                           "mark \"one\"\n"
                           "fill x=11 y=21 width=1 height=1 red=9 green=2 blue=3\n"
                           "frame 0x7f\n"
                           "status\n"
                           "overlay_fill x=0 y=0 width=1 height=1 value=1\n"
                           "lut channels=1 first=1 05\n"
                           "mark \"two\"\n";

Verdict judge(decltype(Check::expectation) expectation, inspect::Moment at = inspect::AtEnd{}) {
  const auto verdicts =
      inspect::evaluate(test::trace_of_text(stream), {{"a check", at, std::move(expectation)}});
  REQUIRE(verdicts.size() == 1);
  CHECK(verdicts[0].holds == verdicts[0].message.empty());
  return verdicts[0];
}

} // namespace

TEST_CASE("a colour that is not everywhere is told with the first pixel that has another") {
  const inspect::ColorCheck check{Surface::image_0, {10, 20, 4, 3}, {1, 2, 3}};
  CHECK(judge(check, std::string("one")).holds);
  CHECK(judge(check, std::uint64_t{3}).holds);
  const Verdict verdict = judge(check);
  CHECK_FALSE(verdict.holds);
  CHECK(verdict.number == 9);
  CHECK(verdict.message ==
        "pixel (11, 21): found 9 2 3, expected 1 2 3; 1 of 12 pixels of 4 x 3 at (10, 20) is wrong");
  CHECK(judge(inspect::ColorCheck{Surface::image_0, {11, 21, 1, 1}, {1, 2, 3}}).message ==
        "pixel (11, 21): found 9 2 3, expected 1 2 3");
}

TEST_CASE("the screen is checked as shown, through the look-up tables") {
  CHECK(judge(inspect::ColorCheck{Surface::screen, {10, 20, 1, 1}, {5, 2, 3}}).holds);
  CHECK(judge(inspect::ColorCheck{Surface::screen, {10, 20, 1, 1}, {1, 2, 3}}, std::string("one")).holds);
}

TEST_CASE("the overlay is checked by bits") {
  CHECK(judge(inspect::ColorCheck{Surface::overlay, {0, 0, 1, 1}, {1, 1, 1}}).holds);
  CHECK(judge(inspect::ColorCheck{Surface::overlay, {0, 0, 2, 1}, {1, 1, 1}}).message ==
        "pixel (1, 0): found 0, expected 1; 1 of 2 pixels of 2 x 1 at (0, 0) is wrong");
  CHECK(judge(inspect::ChecksumCheck{
                  Surface::overlay, {0, 0, 2, 1}, protocol::checksum(std::vector<std::uint8_t>{1, 0})})
            .holds);
}

TEST_CASE("checksums are those of the protocol") {
  const std::vector<std::uint8_t> row{1, 2, 3, 1, 2, 3};
  const std::uint32_t sum = protocol::checksum(row);
  CHECK(judge(inspect::ChecksumCheck{Surface::image_0, {10, 20, 2, 1}, sum}).holds);
  CHECK_FALSE(judge(inspect::ChecksumCheck{Surface::image_0, {10, 21, 2, 1}, sum}).holds);
}

TEST_CASE("an image that is too far off is told with the worst pixel and a difference picture") {
  const png::Picture picture{2, 1, {1, 2, 3, 1, 2, 3}};
  inspect::ImageCheck check{Surface::image_0, {10, 21, 2, 1}, picture, {}, {}, {}};
  const Verdict verdict = judge(check);
  CHECK(verdict.message == "largest difference 8 is over 0; farthest apart is pixel (11, 21): found 9 2 3, "
                           "expected 1 2 3; 1 of 2 pixels differ");
  REQUIRE(verdict.difference);
  CHECK(verdict.difference->width == 2);
  CHECK(judge(check, std::string("one")).holds);
  check.max_difference = 8;
  CHECK(judge(check).holds);
  check.max_difference = 7;
  CHECK_FALSE(judge(check).holds);
  check.max_difference.reset();
  check.max_rmse = 3.3;
  CHECK(judge(check).holds);
  check.differing = 0.49;
  CHECK_FALSE(judge(check).holds);
  check.differing = 0.5;
  CHECK(judge(check).holds);
}

TEST_CASE("registers, counts and tables are told with what was found and expected") {
  CHECK(judge(inspect::SettingsCheck{{{"window", {0, 0, 512, 512}}, {"zoom", {0}}, {"errors", {1}}}}).holds);
  CHECK(judge(inspect::SettingsCheck{{{"pan", {1, 2}}, {"zoom", {1}}}}).message ==
        "pan: found 0 0, expected 1 2; zoom: found 0, expected 1");
  CHECK(judge(inspect::CountsCheck{
                  {{"commands", 9}, {"errors", 1}, {"queries", 1}, {"fill", 2}, {"mark", 2}, {"pixels", 0}}})
            .holds);
  CHECK(judge(inspect::CountsCheck{{{"fill", 2}}}, std::string("one")).message ==
        "fill: found 1, expected 2");
  CHECK(judge(inspect::LutCheck{0, 0, {0, 5, 2}}).holds);
  CHECK(judge(inspect::LutCheck{0, 0, {0, 1, 3}}).message ==
        "entry 1 of red: found 5, expected 1; 2 entries are wrong");
}

TEST_CASE("a restart of the device is counted as no command's name") {
  recording::Trace trace;
  trace.records = {recording::Restart{}, test::trace_of_text("reset\n").records.at(0)};
  const auto verdicts = inspect::evaluate(
      trace, {{"", inspect::AtEnd{}, inspect::CountsCheck{{{"reset", 1}, {"commands", 2}}}}});
  INFO(verdicts[0].message);
  CHECK(verdicts[0].holds);
}

TEST_CASE("a check whose moment never comes does not hold, and says what there is") {
  const Verdict late = judge(inspect::CountsCheck{}, std::uint64_t{10});
  CHECK_FALSE(late.number);
  CHECK(late.message == "the recording ends after command 9");
  CHECK(judge(inspect::CountsCheck{}, std::string("three")).message ==
        "the recording has no mark \"three\"; it has \"one\", \"two\"");
  CHECK(judge(inspect::CountsCheck{}, std::uint64_t{0}).holds);
}

TEST_CASE("of many marks the first ten are told") {
  std::string marks;
  for (int i = 1; i <= 12; ++i) marks += "mark \"" + std::to_string(i) + "\"\n";
  const auto verdicts = inspect::evaluate(test::trace_of_text(marks),
                                          {{"", std::string("13"), inspect::CountsCheck{{{"mark", 12}}}}});
  CHECK(verdicts[0].message == "the recording has no mark \"13\"; it has \"1\", \"2\", \"3\", \"4\", \"5\", "
                               "\"6\", \"7\", \"8\", \"9\", \"10\" and 2 more");
}

TEST_CASE("names of registers and counts are known") {
  CHECK(inspect::numbers_of_setting("window") == 4U);
  CHECK_FALSE(inspect::numbers_of_setting("windows"));
  CHECK(inspect::is_counted("errors"));
  CHECK(inspect::is_counted("overlay_bits"));
  CHECK_FALSE(inspect::is_counted("row"));
}
