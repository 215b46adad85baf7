#include "observed.h"
#include "streams.h"

#include <halftone/inspect/who.h>

#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>

#include <array>

using namespace halftone;
using device::Plane;
using inspect::Place;
using inspect::Write;
using test::Random;

TEST_CASE("who names the command that a replay of every pixel saw write it last") {
  std::size_t asked = 0;
  for (std::uint64_t seed = 100; seed < 130; ++seed) {
    Random random(seed);
    test::Bytes stream = test::random_stream(random);
    if (random() % 3 == 0) stream = test::damaged(random, stream);
    const recording::Trace trace = test::trace_of(stream);

    std::array<std::vector<std::uint64_t>, 3> last; // of each pixel of each plane: the command, 0 is none
    for (auto& plane : last) plane.resize(std::size_t{512} * 512);
    recording::Walk walk(trace);
    device::Device device = walk.device();
    bool has_copy = false;
    while (const auto step = walk.next()) {
      const protocol::Message* message = inspect::message_of(*step);
      has_copy = has_copy || (message != nullptr && message->opcode == protocol::Opcode::copy);
      const test::Written written = test::execute_and_watch(device, step->item);
      for (std::size_t plane = 0; plane < 3; ++plane)
        for (std::size_t i = 0; i < last[plane].size(); ++i)
          if (written[plane][i]) last[plane][i] = step->number;
    }
    if (has_copy) continue; // one onto itself, or of masked bits, cannot be seen

    for (int i = 0; i < 40; ++i) {
      const auto coordinate = [&] { return static_cast<std::uint16_t>(random() % (i % 4 == 0 ? 512 : 40)); };
      const Place place{static_cast<Plane>(random() % 3), coordinate(), coordinate()};
      const inspect::Writers writers = inspect::who(trace, place, 3);
      INFO("seed " << seed << ", plane " << inspect::name_of(place.plane) << " (" << place.x << ", "
                   << place.y << ")");
      const std::uint64_t expected =
          last[static_cast<std::size_t>(place.plane)][std::size_t{place.y} * 512 + place.x];
      REQUIRE((writers.last ? writers.last->command.number : 0) == expected);
      REQUIRE(writers.value == inspect::value_at(device, place));
      if (writers.last) REQUIRE(writers.last->after == writers.value);
      ++asked;
    }
  }
  CHECK(asked > 400);
}

namespace {

const char* const painting = "reset\n"
                             "mark \"sky\"\n"
                             "fill x=0 y=0 width=100 height=100 red=0 green=0 blue=200\n"
                             "mark \"sun\"\n"
                             "fill x=10 y=10 width=5 height=5 red=255 green=255 blue=0\n"
                             "write_mask red=0 green=0 blue=0\n"
                             "#99 fill x=0 y=0 width=100 height=100 red=1 green=2 blue=3\n"
                             "fill x=50 y=50 width=1 height=1 red=9 green=9 blue=9\n";

} // namespace

TEST_CASE("who tells number, place, section and values of every writer, newest first") {
  const recording::Trace trace = test::trace_of_text(painting);
  const inspect::Writers writers = inspect::who(trace, {Plane::image_0, 12, 12}, 10);
  REQUIRE(writers.writes == 4);
  REQUIRE(writers.newest.size() == 4);
  CHECK(writers.commands == 8);
  CHECK(writers.start == device::Pixel{});
  CHECK(writers.value == device::Pixel{255, 255, 0});
  const Write& masked = writers.newest[0];
  CHECK(masked.masked_out);
  CHECK(masked.command.number == 7);
  CHECK(masked.command.sequence == 99);
  CHECK(masked.before == masked.after);
  const Write& sun = writers.newest[1];
  REQUIRE(writers.last);
  CHECK((*writers.last == sun));
  CHECK(sun.command.number == 5);
  CHECK(sun.command.section == "sun");
  CHECK(sun.command.session == 1);
  CHECK(sun.command.offset == 13 + 16 + 24 + 16);
  CHECK(sun.command.text == "fill x=10 y=10 width=5 height=5 red=255 green=255 blue=0");
  CHECK(sun.before == device::Pixel{0, 0, 200});
  CHECK(sun.after == device::Pixel{255, 255, 0});
  CHECK(writers.newest[2].command.section == "sky");
  CHECK(writers.newest[3].command.text == "reset");
  CHECK(writers.newest[3].command.section.empty());
}

TEST_CASE("who keeps no more writers than asked for, and counts the others") {
  const recording::Trace trace = test::trace_of_text(painting);
  const inspect::Writers writers = inspect::who(trace, {Plane::image_0, 12, 12}, 1);
  CHECK(writers.newest.size() == 1);
  CHECK(writers.writes == 4);
  CHECK(writers.last->command.number == 5);
}

TEST_CASE("who stops after the command that it is told") {
  const recording::Trace trace = test::trace_of_text(painting);
  const inspect::Writers writers = inspect::who(trace, {Plane::image_0, 12, 12}, 10, 4);
  CHECK(writers.last->command.number == 3);
  CHECK(writers.commands == 4);
  CHECK(writers.value == device::Pixel{0, 0, 200});
  CHECK(inspect::who(trace, {Plane::image_0, 12, 12}, 10, 0).writes == 0);
  CHECK((inspect::device_after(trace, 4).images[0] == inspect::device_after(trace, 3).images[0]));
  CHECK((inspect::device_after(trace, 0) == device::Device{}));
}

TEST_CASE("a search that goes on command by command finds what it finds at once") {
  const recording::Trace trace = test::trace_of_text(painting);
  inspect::Search search(trace, {Plane::image_0, 12, 12}, 10);
  const inspect::Search::Time past;
  for (std::uint64_t commands = 1; commands < 6; ++commands) {
    REQUIRE_FALSE(search.go_on(6, past));
    REQUIRE(search.writers().commands == commands);
  }
  CHECK(search.go_on(6, past));
  const inspect::Writers stepped = search.writers(),
                         whole = inspect::who(trace, {Plane::image_0, 12, 12}, 10, 6);
  CHECK(stepped.newest == whole.newest);
  CHECK(stepped.value == whole.value);
  while (!search.go_on(inspect::to_the_end, past)) continue;
  CHECK(search.writers().commands == 8);
}

TEST_CASE("a pixel that nobody wrote has no writer") {
  const recording::Trace trace = test::trace_of_text(painting);
  const inspect::Writers writers = inspect::who(trace, {Plane::image_1, 12, 12}, 10, 3);
  CHECK(writers.writes == 1); // reset writes everything
  CHECK_FALSE(inspect::who(test::trace_of_text("clear\n"), {Plane::overlay, 1, 1}, 10).last);
}

TEST_CASE("long data are cut off in the text of a command") {
  std::string row = "pixels";
  for (int i = 0; i < 100; ++i) row += i % 2 == 0 ? " 102030" : " 405060";
  const recording::Trace trace = test::trace_of_text(row + "\npixels ff8000*400\n");
  CHECK(inspect::who(trace, {Plane::image_0, 0, 0}, 1).last->command.text ==
        "pixels 102030 405060 102030 405060 102030 ... (100 pixels)");
  CHECK(inspect::who(trace, {Plane::image_0, 300, 0}, 1).last->command.text == "pixels ff8000*400");
}

TEST_CASE("what a restart of the device erased no client did") {
  recording::Trace trace;
  const recording::Data painted{protocol::assemble("repeat count=1 red=1 green=1 blue=1\n")};
  trace.records = {recording::SessionBegin{"one"}, painted, recording::SessionEnd{"the device restarts"},
                   recording::Restart{}};
  const inspect::Write last = inspect::who(trace, {Plane::image_0, 0, 0}, 1).last.value();
  CHECK(last.command.number == 2);
  CHECK(last.command.text == "the device restarts, through no command");
  CHECK(last.before == device::Pixel{1, 1, 1});
  CHECK(last.after == device::Pixel{0, 0, 0});
}

TEST_CASE("who tells which of several clients it was, counting commands and bytes through all") {
  recording::Trace trace;
  trace.records = {recording::SessionBegin{"one"}, recording::Data{protocol::assemble("clear\n")},
                   recording::SessionEnd{"done"}, recording::SessionBegin{"two"},
                   recording::Data{protocol::assemble("repeat count=1 red=1 green=1 blue=1\n")}};
  const inspect::Reference last = inspect::who(trace, {Plane::image_0, 0, 0}, 1).last->command;
  CHECK(last.session == 2);
  CHECK(last.number == 2);
  CHECK(last.offset == 13);
  CHECK(last.sequence == 1);
}
