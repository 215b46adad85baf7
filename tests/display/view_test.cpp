#include "../cli/small_scene.h"
#include "../link/peer.h"
#include "served.h"
#include "x_server.h"

#include "support/comes_true.h"
#include "support/scratch.h"

#include <halftone/png/png.h>
#include <halftone/protocol/message.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <future>
#include <string>
#include <thread>
#include <variant>

using namespace halftone;
using namespace std::chrono_literals;
namespace fs = std::filesystem;
using test::comes_true;
using test::Running;
using test::XServer;

namespace {

bool is_possible() { return test::are_there({"Xvfb", "xdotool"}, {"window"}, "xvfb, xdotool, libsdl2-dev"); }

bool is_titled(const XServer& x, const std::string& window, const std::string& beginning) {
  return comes_true([&] { return x.title_of(window).starts_with(beginning); });
}

/// Commands that bring pixels.
std::uint64_t rows_sent(const std::string& file) {
  const recording::Trace trace = recording::read_file(file);
  std::uint64_t rows = 0;
  recording::Walk walk(trace);
  while (const auto step = walk.next()) {
    const auto* command = std::get_if<protocol::Message>(&step->item.content);
    if (command != nullptr && command->opcode == protocol::Opcode::pixels) ++rows;
  }
  return rows;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

} // namespace

TEST_CASE("a scene that changes is drawn again, and only rows that differ sent") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  const std::string scene = test::small_scene(160, 120, "srgb");
  scratch.write("scene.toml", scene);
  const XServer x(scratch.path());
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "-o", "out.png", "--record", "r.m508"},
               scratch.path(), {x.environment()});
  const std::string window = x.window_of(view);
  REQUIRE(is_titled(x, window, "scene.toml: done"));
  REQUIRE(rows_sent(scratch / "r.m508") == 120);
  const png::Picture before = png::read(scratch / "out.png");

  scratch.write("scene.toml", "this is no scene");
  CHECK(is_titled(x, window, "scene.toml:1:"));
  // The mirror's foot gets another colour: rows above and below it stay.
  scratch.write("scene.toml", replaced(scene, "mirror = [0.6, 0.6, 0.6]", "mirror = [0.9, 0.2, 0.2]"));
  REQUIRE(is_titled(x, window, "scene.toml: done"));
  const png::Picture after = png::read(scratch / "out.png");
  std::uint64_t differing = 0;
  for (std::size_t y = 0; y < 120; ++y)
    differing += std::equal(before.rgb.begin() + static_cast<std::ptrdiff_t>(480 * y),
                            before.rgb.begin() + static_cast<std::ptrdiff_t>(480 * (y + 1)),
                            after.rgb.begin() + static_cast<std::ptrdiff_t>(480 * y))
                     ? 0U
                     : 1U;
  CHECK(differing > 5);
  CHECK(differing < 110);
  CHECK(rows_sent(scratch / "r.m508") == 120 + differing);

  Running render({HALFTONE_PROGRAM, "render", "scene.toml", "-o", "rendered.png"}, scratch.path());
  REQUIRE(render.wait() == 0);
  CHECK(png::read(scratch / "rendered.png") == after);
}

TEST_CASE("a window closes at once, however long the picture would take") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(512, 512, "srgb"));
  const XServer x(scratch.path());
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "--mode", "reference", "--samples", "100"},
               scratch.path(), {x.environment()});
  const std::string window = x.window_of(view);
  CHECK(is_titled(x, window, "scene.toml: preparing"));
  x.act("key q");
  CHECK(view.wait(5s) == 0); // a row of 512 pixels takes longer
}

TEST_CASE("a window closes though its device says nothing") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(64, 48, "srgb"));
  std::promise<void> over;
  const test::Peer silent(link::UnixAddress{scratch / "s"},
                          [end = over.get_future().share()](int) { end.wait(); });
  const XServer x(scratch.path());
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "--device", silent.address(), "--timeout", "60"},
               scratch.path(), {x.environment()});
  const std::string window = x.window_of(view);
  CHECK(is_titled(x, window, "scene.toml: "));
  x.act("key q");
  CHECK(view.wait(10s) == 0);
  over.set_value();
}

TEST_CASE("a window hears its keys though its device has stopped in a picture") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(512, 512, "srgb"));
  Running server({HALFTONE_M508, "serve", "--listen", "unix:s"}, scratch.path());
  REQUIRE(test::comes_true([&] { return std::filesystem::exists(scratch / "s"); }));
  const XServer x(scratch.path());
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "--device", "unix:s", "--timeout", "60", "-o",
                "out.png", "--mode", "full", "--samples", "2"},
               scratch.path(), {x.environment()});
  const std::string window = x.window_of(view);
  REQUIRE(is_titled(x, window, "scene.toml: "));
  server.send(SIGSTOP);
  std::this_thread::sleep_for(2s); // for what is sent to fill what lies between
  x.act("key 3");
  x.act("key q");
  CHECK(view.wait(10s) == 0);
  server.send(SIGCONT);
  CHECK(test::contents(scratch / "err").find("closed before a picture was done: out.png was not written\n") !=
        std::string::npos);
}

TEST_CASE("a device that goes ends a view with its recording whole and its report told") {
  if (!test::are_there({}, {"vnc"}, "libvncserver-dev")) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(64, 48, "srgb"));
  const Running serve({HALFTONE_M508, "serve", "--listen", "unix:s"}, scratch.path());
  REQUIRE(comes_true([&] { return fs::exists(scratch / "s"); }));
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "--display", "vnc:127.0.0.1:0", "--device", "unix:s",
                "--float", "out.pfm", "--json", "--record", "r.m508"},
               scratch.path());
  REQUIRE(comes_true([&] { return fs::exists(scratch / "out.pfm"); }));
  serve.send(SIGKILL);
  scratch.write("scene.toml", test::small_scene(48, 32, "srgb"));
  CHECK(view.wait() == 5);
  CHECK(test::contents(scratch / "out").starts_with("{"));
  const recording::Trace trace = recording::read_file(scratch / "r.m508");
  REQUIRE(trace.records.size() > 2);
  const auto* end = std::get_if<recording::SessionEnd>(&trace.records[trace.records.size() - 2]);
  REQUIRE(end != nullptr);
  CHECK(end->how.starts_with("the device closed the connection"));
}

TEST_CASE("a recording that cannot grow ends a view with words") {
  if (!test::are_there({}, {"vnc"}, "libvncserver-dev")) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(64, 48, "srgb"));
  Running view({"/bin/sh", "-c",
                "trap '' XFSZ; ulimit -f 8; exec " HALFTONE_PROGRAM
                " view scene.toml --display vnc:127.0.0.1:0 --record r.m508"},
               scratch.path());
  CHECK(view.wait() == 4);
  CHECK(test::contents(scratch / "err").find("r.m508: cannot be written") != std::string::npos);
  const recording::Trace trace = recording::read_file(scratch / "r.m508");
  CHECK(trace.cut_off.empty());
  const recording::SessionEnd end{"r.m508: cannot be written: File too large"};
  CHECK(std::ranges::find(trace.records, recording::Record(end)) != trace.records.end());
}

TEST_CASE("a picture that cannot be written while its view ends is told") {
  if (!test::are_there({}, {"vnc"}, "libvncserver-dev")) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(64, 48, "srgb"));
  fs::create_directory(scratch / "kept");
  const Running serve({HALFTONE_M508, "serve", "--listen", "unix:s"}, scratch.path());
  REQUIRE(comes_true([&] { return fs::exists(scratch / "s"); }));
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "--display", "vnc:127.0.0.1:0", "--device", "unix:s",
                "--mode", "reference", "--samples", "20", "-o", "kept/out.png", "--record", "r.m508"},
               scratch.path());
  const auto rows = [&] { return fs::exists(scratch / "r.m508") ? rows_sent(scratch / "r.m508") : 0; };
  REQUIRE(comes_true([&] { return rows() > 0; }));
  serve.send(SIGSTOP);
  REQUIRE(comes_true([&] { return rows() == 48; })); // a socket holds them, and the device is asked for them
  fs::remove(scratch / "kept");
  view.send(SIGTERM);
  std::this_thread::sleep_for(100ms); // nobody looks any more, and the device is still waited for
  serve.send(SIGCONT);
  CHECK(view.wait() == 4);
  CHECK(test::contents(scratch / "err") ==
        "halftone: kept/out.png: cannot be written: No such file or directory\n");
}

TEST_CASE("an X server that goes ends a view with its recording whole") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(64, 48, "srgb"));
  const XServer x(scratch.path());
  Running view({HALFTONE_PROGRAM, "view", "scene.toml", "-o", "out.png", "--record", "r.m508"},
               scratch.path(), {x.environment()});
  REQUIRE(is_titled(x, x.window_of(view), "scene.toml: done"));
  x.kill();
  CHECK(view.wait() == 4);
  CHECK(test::contents(scratch / "err") == "halftone: display window: the X server has gone\n");
  const recording::Trace trace = recording::read_file(scratch / "r.m508");
  CHECK(std::ranges::find(trace.records, recording::Record(recording::SessionEnd{"the window has gone"})) !=
        trace.records.end());
  CHECK(std::filesystem::exists(scratch / "out.png"));
}

TEST_CASE("a view keeps and tells what a render does") {
  if (!test::are_there({}, {"vnc"}, "libvncserver-dev")) return;
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(64, 48, "srgb"));
  const auto drawn = [&](const std::vector<std::string>& command, const std::string& name) {
    std::vector<std::string> words{HALFTONE_PROGRAM};
    words.insert(words.end(), command.begin(), command.end());
    for (const std::string& word : {std::string("scene.toml"), std::string("-o"), name + ".png",
                                    std::string("--screen"), name + "-screen.png", std::string("--float"),
                                    name + ".pfm", std::string("--record"), name + ".m508"})
      words.push_back(word);
    return words;
  };
  Running render(drawn({"render"}, "render"), scratch.path());
  REQUIRE(render.wait() == 0);
  for (const std::string told : {"--stats", "--json"}) {
    Running view(drawn({"view", "--display", "vnc:127.0.0.1:0", told}, "view"), scratch.path());
    const auto is_told = [&] { return test::contents(scratch / "out").find("threads") != std::string::npos; };
    CHECK(comes_true([&] { return told == "--stats" ? is_told() : fs::exists(scratch / "view.pfm"); }));
    view.send(SIGTERM);
    CHECK(view.wait() == 0);
    CAPTURE(told, test::contents(scratch / "err"));
    CHECK(is_told());
    for (const std::string file : {".png", "-screen.png", ".pfm"}) {
      CAPTURE(file);
      CHECK((test::contents(scratch / ("view" + file)) == test::contents(scratch / ("render" + file))));
      fs::remove(scratch / ("view" + file));
    }
    // The object is alone on standard output.
    CHECK(test::contents(scratch / "out").starts_with(told == "--json" ? "{" : "display vnc on "));
  }
  Running help({HALFTONE_PROGRAM, "view", "--help"}, scratch.path());
  CHECK(help.wait() == 0);
  CHECK(test::contents(scratch / "out").find("pipe:") == std::string::npos); // a view is refused there
}

TEST_CASE("errors of a scene are told before a window is opened") {
  const test::Scratch scratch;
  scratch.write("scene.toml", "format = 2\n");
  Running view({HALFTONE_PROGRAM, "view", "scene.toml"}, scratch.path());
  CHECK(view.wait() == 3);
  CHECK(test::contents(scratch / "err").starts_with("halftone: scene.toml:"));
}
