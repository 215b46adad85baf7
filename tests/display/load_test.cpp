#include "../cli/small_scene.h"
#include "served.h"
#include "x_server.h"

#include "support/scratch.h"
#include "support/skip.h"

#include <halftone/display/open.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

using namespace halftone;
using test::Running;

namespace {

/// Libraries of displays among the files that a program opened.
std::vector<std::string> libraries_in(const std::string& calls) {
  std::vector<std::string> found;
  for (const std::string name : {"libSDL2", "libX11", "libxcb", "libwayland", "libGL", "libvncserver",
                                 "libwebsockets", "halftone-display"})
    if (calls.find(name) != std::string::npos) found.push_back(name);
  return found;
}

} // namespace

TEST_CASE("a display is called by its name, and what stands behind a colon") {
  CHECK(display::parse_choice("window") == display::Choice{"window", ""});
  CHECK(display::parse_choice("vnc:127.0.0.1:5901") == display::Choice{"vnc", "127.0.0.1:5901"});
  CHECK_THROWS_WITH(display::parse_choice("windows"),
                    "there is no display \"windows\"; there are window, vnc, web");
}

TEST_CASE("a missing module is told with the package that it is built with") {
  const test::Scratch scratch;
  CHECK_THROWS_WITH(
      display::open({"window", ""}, {scratch.path()}),
      "display window: this build has no halftone-display-window.so; install libsdl2-dev and build again");
}

TEST_CASE("a module that cannot be loaded is told with the packages it needs") {
  const test::Scratch scratch;
  scratch.write("halftone-display-vnc.so", "no library");
  CHECK_THROWS_WITH(display::open({"vnc", ""}, {scratch.path()}),
                    Catch::Contains("invalid ELF header") || Catch::Contains("file too short"));
  CHECK_THROWS_WITH(display::open({"vnc", ""}, {scratch.path()}),
                    Catch::EndsWith("the packages needed are: libvncserver1"));
}

TEST_CASE("a missing display is one line and exit code 4") {
  const test::Scratch scratch;
  std::filesystem::copy(HALFTONE_M508, scratch / "m508"); // beside it there are no modules
  Running server({scratch / "m508", "serve", "--display", "window", "--listen", "unix:s"}, scratch.path());
  CHECK(server.wait() == 4);
  CHECK(test::contents(scratch / "err") ==
        "m508: display window: this build has no halftone-display-window.so; install "
        "libsdl2-dev and build again\n");
  CHECK(test::contents(scratch / "out").empty());
}

TEST_CASE("without a desktop a window is refused") {
  if (!test::are_there({}, {"window"}, "libsdl2-dev")) return;
  const test::Scratch scratch;
  const std::vector<std::string> serve{HALFTONE_M508, "serve", "--display", "window", "--listen", "unix:s"};
  std::vector<std::string> words{"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY"};
  words.insert(words.end(), serve.begin(), serve.end());
  Running nowhere(words, scratch.path());
  CHECK(nowhere.wait() == 4);
  CHECK(test::contents(scratch / "err") ==
        "m508: display window: there is no desktop: neither DISPLAY nor WAYLAND_DISPLAY is set\n");
  words[2] = "WAYLAND_DISPLAY"; // SDL would take a driver that shows nothing
  words.insert(words.begin() + 5, "DISPLAY=:65000");
  Running unreachable(words, scratch.path());
  CHECK(unreachable.wait() == 4);
  CHECK(test::contents(scratch / "err").find("WAYLAND_DISPLAY names cannot be reached\n") !=
        std::string::npos);
}

TEST_CASE("an unknown display is a bad argument") {
  const test::Scratch scratch;
  Running server({HALFTONE_M508, "serve", "--display", "windows"}, scratch.path());
  CHECK(server.wait() == 2);
}

TEST_CASE("two windows are one bad argument") {
  const test::Scratch scratch;
  scratch.write("scene.toml", test::small_scene(24, 18, "srgb"));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{HALFTONE_M508, "serve"}, {HALFTONE_PROGRAM, "view", "scene.toml"}}) {
    std::vector<std::string> words = command;
    for (int i = 0; i < 2; ++i) words.insert(words.end(), {"--display", "window"});
    Running program(words, scratch.path());
    CHECK(program.wait() == 2);
    CHECK(test::contents(scratch / "err")
              .ends_with(": --display: there is one window, and it was asked for more than once\n"));
  }
}

TEST_CASE("a headless render opens no library of a display") {
  const test::Scratch scratch;
  if (!test::are_there({"strace"}, {}, "strace")) return;
  const std::vector<std::string> trace{"strace", "-f", "-e", "trace=open,openat", "-o", "calls"};
  const auto traced = [&](std::vector<std::string> words) {
    words.insert(words.begin(), trace.begin(), trace.end());
    Running program(words, scratch.path());
    return program.wait();
  };
  if (traced({"true"}) != 0) {
    test::skip("strace may not look at programs here");
    return;
  }
  scratch.write("scene.toml", test::small_scene(24, 18, "srgb"));
  REQUIRE(traced({HALFTONE_PROGRAM, "render", "scene.toml", "-o", "out.png", "--record", "r.m508"}) == 0);
  CHECK(test::contents(scratch / "calls").find("scene.toml") != std::string::npos);
  CHECK(libraries_in(test::contents(scratch / "calls")).empty());
  REQUIRE(traced({HALFTONE_M508, "replay", "r.m508"}) == 0);
  CHECK(libraries_in(test::contents(scratch / "calls")).empty());

  if (!test::are_there({}, {"window"}, "libsdl2-dev")) return;
  // The same look does find it where it is loaded.
  traced({"env", "-u", "DISPLAY", HALFTONE_M508, "replay", "r.m508", "--display", "window"});
  CHECK(libraries_in(test::contents(scratch / "calls")).size() >= 2);
}
