#include "../cli/small_scene.h"
#include "../serve/client.h"
#include "served.h"
#include "x_server.h"

#include "support/comes_true.h"

#include <halftone/device/port.h>
#include <halftone/device/screen.h>
#include <halftone/inspect/who.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>
#include <halftone/protocol/message.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;
using test::comes_true;
using test::Running;
using test::screen_of;
using test::XServer;

namespace {

bool is_possible() {
  return test::are_there({"Xvfb", "xdotool", "import"}, {"window"},
                         "xvfb, xdotool, imagemagick, libsdl2-dev");
}

/// The screen as the window has it, `scale` pixels for each, in the middle.
png::Picture in_window(const device::Bytes& screen, int width, int height, int scale) {
  constexpr std::uint8_t ground = 24;
  png::Picture picture{width, height,
                       std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), ground)};
  const int left = (width - 512 * scale) / 2, top = (height - 512 * scale) / 2;
  for (int y = 0; y < 512 * scale; ++y)
    for (int x = 0; x < 512 * scale; ++x)
      for (int c = 0; c < 3; ++c)
        picture.rgb[static_cast<std::size_t>(3 * ((top + y) * width + left + x) + c)] =
            screen[static_cast<std::size_t>(3 * (y / scale * 512 + x / scale) + c)];
  return picture;
}

png::Picture in_window(const device::Bytes& screen) { return in_window(screen, 1024, 1024, 2); }

/// m508 serve with a window, and a client that has sent noise to both image buffers and to the overlay.
struct Served {
  Served() {
    REQUIRE_FALSE(window.empty());
    REQUIRE(comes_true([&] { return std::filesystem::exists(scratch / "s"); }));
    link = link::open("unix:" + scratch / "s");
    test::send_noise(*link);
  }

  /// Whether the window comes to show what the device says it shows, which it says to its client.
  bool is_shown() {
    return comes_true([&] { return x.picture_of(window) == in_window(screen_of(*link)); });
  }

  test::Scratch scratch;
  XServer x{scratch.path()};
  Running server{{HALFTONE_M508, "serve", "--display", "window", "--listen", "unix:s", "--record", "r.m508",
                  "-o", "end.png"},
                 scratch.path(),
                 {x.environment()}};
  std::string window = x.window_of(server);
  std::unique_ptr<link::Link> link;
};

/// So many commands that each take some 40 us, as a raw stream.
void write_fills(const std::string& file, std::uint32_t count) {
  std::vector<std::uint8_t> stream;
  for (std::uint32_t i = 0; i < count; ++i)
    append(stream, protocol::Message{protocol::Opcode::fill, i, {0, 0, 512, 512, i % 256, 1, 2}, {}});
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(stream.data()), static_cast<std::streamsize>(stream.size()));
}

/// A recording of a small picture: one command a row.
recording::Trace record_picture(const test::Scratch& scratch) {
  scratch.write("scene.toml", test::small_scene(120, 90, "srgb"));
  Running render({HALFTONE_PROGRAM, "render", "scene.toml", "--record", "r.m508"}, scratch.path());
  REQUIRE(render.wait() == 0);
  return recording::read_file(scratch / "r.m508");
}

/// A recording of a small picture in a window, without what lies over the picture.
struct Replayed {
  explicit Replayed(const std::vector<std::string>& options)
      : replay(command_with(options), scratch.path(), {x.environment()}) {
    x.act("key i");
  }

  /// Whether the window comes to hold what is there after so many commands.
  bool shows(std::uint64_t commands) {
    const png::Picture wanted = in_window(device::screen(inspect::device_after(trace, commands)));
    return comes_true([&] { return x.picture_of(window) == wanted; });
  }

  test::Scratch scratch;
  recording::Trace trace = record_picture(scratch);
  XServer x{scratch.path()};
  Running replay;
  std::string window = x.window_of(replay);

private:
  static std::vector<std::string> command_with(const std::vector<std::string>& options) {
    std::vector<std::string> words{HALFTONE_M508, "replay", "r.m508", "--display", "window"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
};

} // namespace

TEST_CASE("a window is drawn in memory and goes to the screen without OpenGL") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  const std::string mapped = test::contents("/proc/" + std::to_string(served.server.number()) + "/maps");
  CHECK(mapped.find("libSDL2") != std::string::npos);
  CHECK(mapped.find("libGL") == std::string::npos);
}

TEST_CASE("the window shows what the device says is shown") {
  if (!is_possible()) return;
  Served served;
  CHECK(served.is_shown());
  CHECK(served.x.title_of(served.window) == "m508 on unix:s");
}

TEST_CASE("keys do to the device what they say, and the window shows it") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  for (const std::string keys :
       {"plus", "Right", "shift+Down", "4", "3", "2", "1", "b", "b", "o", "plus plus", "minus", "0"}) {
    const device::Bytes before = screen_of(*served.link);
    served.x.act("key " + keys);
    CAPTURE(keys);
    REQUIRE(comes_true([&] { return screen_of(*served.link) != before; }));
    REQUIRE(served.is_shown());
  }
}

TEST_CASE("the wheel zooms where the mouse is, and dragging pans") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  const auto pan_and_zoom = [&] {
    const recording::Trace trace = recording::read_file(served.scratch / "r.m508");
    const device::Registers registers = inspect::device_after(trace).registers;
    return std::vector<int>{registers.pan_x, registers.pan_y, registers.zoom};
  };
  served.x.act("mousemove --window " + served.window + " 601 401 click 4");
  CHECK(comes_true([&] { return pan_and_zoom() == std::vector{150, 100, 1}; }));
  served.x.act("mousedown 1 mousemove_relative --sync -- -80 40 mouseup 1");
  CHECK(comes_true([&] { return pan_and_zoom() == std::vector{170, 90, 1}; }));
  CHECK(served.is_shown());
}

TEST_CASE("what keys did is recorded, and in the picture at the end") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  served.x.act("key plus 2");
  REQUIRE(comes_true([&] { return screen_of(*served.link)[0] != 0 && served.is_shown(); }));
  const png::Picture seen = served.x.picture_of(served.window);
  served.link.reset();
  served.x.act("key q");
  CHECK(served.server.wait() == 0);
  const png::Picture end = png::read(served.scratch / "end.png");
  CHECK(seen == in_window(end.rgb));
  const recording::Trace trace = recording::read_file(served.scratch / "r.m508");
  CHECK(device::screen(inspect::device_after(trace)) == end.rgb);
  CHECK_FALSE(recording::departure(trace));
}

TEST_CASE("a window of any size has the screen in its middle, in whole pixels") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  const device::Bytes screen = screen_of(*served.link);
  served.x.act("windowsize " + served.window + " 1100 900");
  CHECK(comes_true([&] { return served.x.picture_of(served.window) == in_window(screen, 1100, 900, 1); }));
  served.x.act("windowsize " + served.window + " 1026 1060");
  CHECK(comes_true([&] { return served.x.picture_of(served.window) == in_window(screen, 1026, 1060, 2); }));
}

TEST_CASE("help and words about a pixel go as they came") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  const png::Picture plain = served.x.picture_of(served.window);
  for (const std::string action : {"key h", "mousemove 640 400 click 1"}) {
    CAPTURE(action);
    served.x.act(action);
    CHECK(comes_true([&] { return served.x.picture_of(served.window) != plain; }));
    served.x.act("key Escape");
    CHECK(comes_true([&] { return served.x.picture_of(served.window) == plain; }));
  }
}

TEST_CASE("key p keeps what is shown as a PNG") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  served.x.act("key p");
  const std::string file = served.scratch / "screen-0001.png";
  REQUIRE(comes_true([&] { return std::filesystem::exists(file); }));
  CHECK(png::read(file).rgb == screen_of(*served.link));
}

TEST_CASE("a recording is shown at its end, and forward and back by keys") {
  if (!is_possible()) return;
  Replayed replayed({});
  CHECK(replayed.shows(inspect::to_the_end));
  replayed.x.act("key Home");
  CHECK(replayed.shows(0));
  replayed.x.act("key --repeat 40 period");
  CHECK(replayed.shows(40));
  replayed.x.act("key --repeat 10 comma");
  CHECK(replayed.shows(30));
  replayed.x.act("key End");
  CHECK(replayed.shows(inspect::to_the_end));
  replayed.x.act("mousemove --window " + replayed.window + " 512 600 click 3");
  std::uint64_t length = 0;
  for (recording::Walk walk(replayed.trace); walk.next();) ++length;
  CHECK(replayed.shows((length + 1) / 2)); // half of the width
  replayed.x.act("key q");
  CHECK(replayed.replay.wait() == 0);
  CHECK(test::contents(replayed.scratch / "out").find("rejected   0") != std::string::npos);
}

TEST_CASE("a window answers before a long replay is over") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  write_fills(scratch / "raw", 20'000);
  const XServer x(scratch.path());
  // Twenty thousand pictures take minutes.
  const auto replay = [&](const std::string& each) {
    return std::vector<std::string>{HALFTONE_M508, "replay", "raw", "--display", "window",
                                    "--each",      each,     "-o",  "p.png"};
  };
  Running slow(replay("1"), scratch.path(), {x.environment()});
  const std::string window = x.window_of(slow);
  CHECK(comes_true([&] { return std::filesystem::exists(scratch / "p-00000009.png"); }));
  // Paused, and without the status line, nothing moves but what keys do.
  x.act("key i space");
  png::Picture before;
  REQUIRE(comes_true([&] {
    const png::Picture earlier = std::exchange(before, x.picture_of(window));
    return !before.rgb.empty() && earlier == before;
  }));
  x.act("key h");
  CHECK(comes_true([&] { return x.picture_of(window) != before; }));
  x.act("key Escape");
  CHECK(comes_true([&] { return x.picture_of(window) == before; }));
  CHECK_FALSE(std::filesystem::exists(scratch / "p.png"));
  slow.send(SIGTERM);
  CHECK(slow.wait(5s) == 4);
  CHECK(test::contents(scratch / "err").starts_with("m508: raw: stopped by a signal after command "));
  CHECK_FALSE(std::filesystem::exists(scratch / "p.png"));

  // Who closes the window gets the picture for all that.
  Running closed(replay("1000"), scratch.path(), {x.environment()});
  x.window_of(closed);
  x.act("key q");
  CHECK(closed.wait() == 0);
  CHECK(std::filesystem::exists(scratch / "p.png"));
}

TEST_CASE("who closes a window for which nothing is written ends a long replay") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  write_fills(scratch / "raw", 1'000'000); // 40 s of work
  const XServer x(scratch.path());
  Running replay({HALFTONE_M508, "replay", "raw", "--display", "window"}, scratch.path(), {x.environment()});
  x.window_of(replay);
  x.act("key q");
  CHECK(replay.wait(10s) == 0);
  CHECK(test::contents(scratch / "err").starts_with("m508: raw: closed after command "));
  CHECK(test::contents(scratch / "out").starts_with("commands   "));
}

TEST_CASE("a signal ends the rest of a replay whose window was closed") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  write_fills(scratch / "raw", 1'000'000);
  const XServer x(scratch.path());
  Running replay({HALFTONE_M508, "replay", "raw", "--display", "window", "-o", "p.png"}, scratch.path(),
                 {x.environment()});
  x.window_of(replay);
  x.act("key q");
  const std::string playing = "m508: raw: playing the rest, for p.png\n";
  REQUIRE(comes_true([&] { return test::contents(scratch / "err") == playing; }));
  replay.send(SIGTERM);
  CHECK(replay.wait(10s) == 4);
  CHECK(
      test::contents(scratch / "err").starts_with(playing + "m508: raw: stopped by a signal after command "));
  CHECK_FALSE(std::filesystem::exists(scratch / "p.png"));
}

TEST_CASE("a recording at its pace stops where it is to stop") {
  if (!is_possible()) return;
  Replayed replayed({"--pace", "--until", "50"});
  REQUIRE(replayed.shows(50));
  replayed.x.act("key period");
  CHECK(replayed.shows(51));
  replayed.x.act("key q");
  CHECK(replayed.replay.wait() == 0);
}

TEST_CASE("a recording is shown where it is to stop") {
  if (!is_possible()) return;
  Replayed replayed({"--until", "50"});
  CHECK(replayed.shows(50));
  replayed.x.act("key q");
  CHECK(replayed.replay.wait() == 0);
}

TEST_CASE("at the pace of 19200 baud the picture is painted row by row") {
  if (!is_possible()) return;
  Replayed replayed({"--pace", "--bus", "rs232"});
  // 91 rows of 373 bytes take 18 s; some of them are there, and then more.
  const auto rows_there = [&] {
    const png::Picture seen = replayed.x.picture_of(replayed.window);
    for (std::uint64_t rows = 0; rows < 94; ++rows)
      if (seen == in_window(device::screen(inspect::device_after(replayed.trace, rows)))) return rows;
    return std::uint64_t{0};
  };
  std::uint64_t first = 0;
  REQUIRE(comes_true([&] { return (first = rows_there()) > 4; }));
  CHECK(first < 80);
  CHECK(comes_true([&] { return rows_there() > first; }));
  replayed.x.act("key f f f f f");
  CHECK(replayed.shows(inspect::to_the_end));
}

TEST_CASE("an X server that goes ends a window with the files written") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  const device::Bytes screen = screen_of(*served.link);
  served.x.kill();
  CHECK(served.server.wait() == 4);
  CHECK(test::contents(served.scratch / "err") == "m508: display window: the X server has gone\n");
  CHECK(png::read(served.scratch / "end.png").rgb == screen);
  const recording::Trace trace = recording::read_file(served.scratch / "r.m508");
  CHECK(std::ranges::any_of(trace.records, [](const recording::Record& record) {
    return std::holds_alternative<recording::SessionEnd>(record);
  }));
  CHECK(device::screen(inspect::device_after(trace)) == screen);
}

TEST_CASE("a signal ends a window with the files written") {
  if (!is_possible()) return;
  Served served;
  REQUIRE(served.is_shown());
  served.server.send(SIGTERM);
  CHECK(served.server.wait() == 0);
  CHECK(std::filesystem::exists(served.scratch / "end.png"));
}
