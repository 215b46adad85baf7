#include "fake_display.h"
#include "support/messages.h"
#include "support/scratch.h"

#include <halftone/watch/watcher.h>

#include <halftone/bus/buses.h>
#include <halftone/device/screen.h>
#include <halftone/inspect/who.h>
#include <halftone/png/png.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>

using namespace halftone;
namespace display = halftone::display;
using protocol::Opcode;
using test::bytes_of;

namespace {

/// A device that is watched while it is sent to.
struct Watched {
  void send(const device::Bytes& bytes) {
    writer.data(bytes);
    protocol::Decoder decoder(protocol::Direction::to_device);
    for (std::span<const std::uint8_t> rest = bytes; const auto item = decoder.next(rest);)
      device.execute(*item);
  }

  /// Looks until the displays have had time to be shown what has changed.
  bool look(const std::vector<display::Event>& events = {}) {
    log.events = events;
    bool goes_on = true;
    for (int i = 0; i < 4; ++i) goes_on = watcher.look() && goes_on;
    return goes_on;
  }

  device::Device device;
  watch::Tape tape;
  recording::Writer writer{[this](std::span<const std::uint8_t> bytes) { tape.append(bytes); }, device};
  watch::Player player{{}, recording::Trail::grows};
  test::FakeDisplay::Log log;
  watch::Displays displays = [this] {
    watch::Displays all;
    all.push_back(std::make_unique<test::FakeDisplay>(log));
    return all;
  }();
  std::vector<device::Bus> buses = bus::built_in();
  watch::Watcher watcher{
      displays,
      player,
      tape,
      buses,
      {[] { return "a device"; }, [this](const device::Bytes& commands) { send(commands); }}};
};

device::Bytes fill(std::uint32_t row, std::uint32_t red) {
  return bytes_of({{Opcode::fill, red, {10, row, 20, 1, red, 0, 0}, {}}});
}

} // namespace

TEST_CASE("what the device shows is shown, and only rows that changed are told") {
  Watched watched;
  watched.look();
  CHECK(watched.log.changes == std::vector{display::Rows{0, 512}});
  watched.send(fill(100, 7));
  watched.look();
  CHECK(watched.log.changes.back() == display::Rows{100, 1});
  CHECK(watched.log.screen == device::screen(watched.device));
  watched.send(fill(300, 0)); // black on black
  watched.look();
  CHECK(watched.log.changes.size() == 2);
  CHECK(watched.log.words.title == "a device");
  CHECK(watched.log.words.status.empty());
}

TEST_CASE("keys reach the device that is sent to, one after the other") {
  Watched watched;
  watched.send(fill(100, 7));
  watched.look({display::Zoom{1, 0, 0}, display::Zoom{1, 0, 0}, display::Pan{0, 90}, display::Pan{3, 0}});
  CHECK(watched.device.registers.zoom == 2);
  CHECK(watched.device.registers.pan_x == 3);
  CHECK(watched.device.registers.pan_y == 90);
  CHECK(watched.log.screen == device::screen(watched.device));
}

TEST_CASE("dragging pulls the image by as much as the mouse goes") {
  Watched watched;
  watched.look({display::Zoom{3, 0, 0}, display::Drag{true, 100, 100}});
  for (int x = 101; x <= 140; ++x) {
    watched.log.events = {display::Drag{false, x, 100}};
    watched.watcher.look();
  }
  CHECK(watched.device.registers.pan_x == 512 - 5); // 40 pixels of the screen, each 8 of the image
}

TEST_CASE("keys during a pause are for the picture, and later for the device") {
  Watched watched;
  watched.send(fill(100, 7));
  watched.look();
  const device::Bytes before = watched.log.screen;
  watched.look({display::Pause{}});
  watched.send(fill(100, 9));
  watched.look();
  CHECK(watched.log.screen == before);
  CHECK(watched.log.words.status == "command 1 of 2, paused");
  watched.look({display::Zoom{1, 0, 0}});
  CHECK(watched.log.screen != before);
  CHECK(watched.device.registers.zoom == 0);
  watched.look({display::Follow{}});
  CHECK(watched.device.registers.zoom == 1);
  CHECK(watched.log.screen == device::screen(watched.device));
  CHECK(watched.log.words.status.empty());
}

TEST_CASE("scrubbing goes to a command, forward and back") {
  Watched watched;
  for (std::uint32_t i = 0; i < 100; ++i) watched.send(fill(i, 200));
  watched.look();
  using By = display::Scrub::By;
  const auto shows = [&](std::uint64_t place) {
    return watched.log.screen == device::screen(inspect::device_after(watched.player.trace(), place));
  };
  watched.look({display::Scrub{By::place, 0.25}});
  CHECK(shows(25));
  watched.look({display::Scrub{By::commands, -1}});
  CHECK(shows(24));
  watched.look({display::Scrub{By::share, 0.5}});
  CHECK(shows(74));
  CHECK(watched.log.words.place == Approx(0.74));
  watched.look({display::Scrub{By::share, 0.5}});
  CHECK(shows(100));
}

TEST_CASE("a probe tells the value and the command that wrote it") {
  Watched watched;
  watched.send(fill(100, 7));
  watched.send(fill(101, 8));
  watched.send(fill(100, 9));
  watched.look({display::Probe{15, 100}});
  CHECK(watched.log.words.probed ==
        std::vector<std::string>{"screen (15, 100): 9 0 0", "image0 (15, 100): 9 0 0",
                                 "written by command 3, session 1, sequence 9",
                                 "fill x=10 y=100 width=20 height=1 red=9 green=0 blue=0"});
  watched.look({display::Scrub{display::Scrub::By::commands, -1}});
  CHECK(watched.log.words.probed.at(2) == "written by command 1, session 1, sequence 7");
  watched.look({display::Probe{9, 100}});
  CHECK(watched.log.words.probed.at(2) == "no command has written it");
  watched.look({display::EndProbe{}});
  CHECK(watched.log.words.probed.empty());
}

TEST_CASE("many scrubs at once lead where they would lead one by one") {
  Watched watched;
  for (std::uint32_t i = 0; i < 100; ++i) watched.send(fill(i, 200));
  watched.look();
  using By = display::Scrub::By;
  watched.look({display::Scrub{By::place, 0.9}, display::Scrub{By::share, 0.5},
                display::Scrub{By::commands, -30}, display::Probe{15, 99}, display::Scrub{By::share, -0.1}});
  CHECK(watched.player.position() == 60);
  watched.look({display::Scrub{By::place, 0.2}, display::Zoom{1, 0, 0}, display::Follow{},
                display::Scrub{By::commands, -1}});
  CHECK(watched.player.position() == 99); // what following has sent is not played yet
  CHECK(watched.device.registers.zoom == 1);
}

TEST_CASE("neither scrubs nor a probe walk through the stream again and again") {
  Watched watched;
  device::Bytes stream;
  for (std::uint32_t i = 0; i < 40'000; ++i)
    append(stream, protocol::Message{Opcode::fill, i, {0, i % 512, 512, 1, i % 256, 0, 0}, {}});
  watched.send(stream);
  while (watched.player.length() < 40'000) watched.look();
  const auto processor_time = [&](const std::vector<display::Event>& events) {
    const std::clock_t begin = std::clock();
    watched.look(events);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  using By = display::Scrub::By;
  const double one = processor_time({display::Scrub{By::place, 0.5}});
  std::vector<display::Event> many;
  for (int i = 0; i < 300; ++i) many.emplace_back(display::Scrub{By::place, i % 2 == 0 ? 0.9 : 0.3});
  CHECK(processor_time(many) < 10 * one);

  // The first question walks through all of it, the others through what has come since.
  watched.look({display::Follow{}});
  double first = processor_time({display::Probe{15, 100}});
  while (watched.log.words.probed.back().starts_with("looking")) first += processor_time({});
  double others = 0;
  for (std::uint32_t i = 0; i < 10; ++i) {
    watched.send(fill(100, i + 1));
    others += processor_time({});
    CHECK(watched.log.words.probed.at(3).starts_with("fill x=10 y=100 width=20 height=1 red=" +
                                                     std::to_string(i + 1)));
  }
  CAPTURE(first, others);
  CHECK(others < 5 * first);
}

TEST_CASE("who looks for the writer of a pixel in a long stream keeps nobody waiting") {
  Watched watched;
  constexpr std::uint32_t count = 8'000;
  device::Bytes stream;
  for (std::uint32_t i = 1; i <= count; ++i)
    append(stream, protocol::Message{Opcode::fill, i, {0, 0, 512, 512, i % 256, 1, 2}, {}});
  watched.writer.data(stream);
  while (watched.player.length() < count) watched.look();
  watched.log.events = {display::Probe{15, 100}};
  double longest = 0, all = 0;
  int looks = 0;
  const auto is_looking = [&] {
    const std::vector<std::string>& probed = watched.log.words.probed;
    return probed.empty() || probed.back() == "looking for who wrote it ...";
  };
  do {
    const std::clock_t begin = std::clock();
    watched.watcher.look();
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    longest = std::max(longest, took);
    all += took;
  } while (is_looking() && ++looks < 100'000);
  CAPTURE(longest, all, looks);
  CHECK(looks > 2);
  CHECK(longest < 0.1);
  CHECK(watched.log.words.probed ==
        std::vector<std::string>{"screen (15, 100): 64 1 2", "image0 (15, 100): 64 1 2",
                                 "written by command 8000, session 1, sequence 8000",
                                 "fill x=0 y=0 width=512 height=512 red=64 green=1 blue=2"});
}

TEST_CASE("a pace slower than the stream shows less of it, and says so") {
  Watched watched;
  watched.look(std::vector(5, display::Event(display::Pace{-1})));
  CHECK(watched.log.words.status == "command 0 of 0, at the pace of rs232");
  for (std::uint32_t i = 0; i < 400; ++i) watched.send(fill(i, 200));
  for (int i = 0; i < 100 && watched.player.length() < 400; ++i) watched.look();
  CHECK(watched.player.length() == 400);
  CHECK(watched.player.position() < 300); // each takes 14 ms
  watched.look(std::vector(5, display::Event(display::Pace{1})));
  CHECK(watched.player.is_following());
  CHECK(watched.log.screen == device::screen(watched.device));
}

TEST_CASE("a screenshot is the device's screen in the first file that is free") {
  const test::Scratch scratch;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(scratch.path());
  scratch.write("screen-0001.png", "somebody's");
  Watched watched;
  watched.send(fill(100, 7));
  watched.look({display::Screenshot{}});
  std::filesystem::current_path(before);
  CHECK(scratch.names() == std::vector<std::string>{"screen-0001.png", "screen-0002.png"});
  CHECK(png::read(scratch / "screen-0002.png").rgb == device::screen(watched.device));
  CHECK(watched.log.words.status == "kept as screen-0002.png");
}

TEST_CASE("whoever quits ends it") {
  Watched watched;
  CHECK(watched.look());
  CHECK_FALSE(watched.look({display::Pause{}, display::Quit{}}));
}
