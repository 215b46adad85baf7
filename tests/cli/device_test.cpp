// render with devices of every kind.

#include "small_scene.h"
#include "support/full_disk.h"
#include "support/process.h"
#include "support/scratch.h"

#include <halftone/device/port.h>
#include <halftone/device/screen.h>
#include <halftone/png/png.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <algorithm>

#include <string>
#include <vector>

using namespace halftone;
using test::contents;
using test::Outcome;
using test::run_halftone;
using test::Scratch;
using test::small_scene;

namespace {

device::Bytes screen_of(const std::string& commands) {
  device::Port port;
  device::Bytes replies;
  port.receive({reinterpret_cast<const std::uint8_t*>(commands.data()), commands.size()}, replies);
  port.end(replies);
  return device::screen(port.device);
}

} // namespace

TEST_CASE("a file or a pipe takes the commands of the picture, and stderr says that there is no PNG") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  REQUIRE(
      run_halftone({"render", "s.toml", "--screen", "screen.png"}, {.folder = scratch.path()}).exit_code ==
      0);
  const Outcome file = run_halftone({"render", "s.toml", "--device", "file:c"}, {.folder = scratch.path()});
  CHECK(file.exit_code == 0);
  CHECK(file.out.empty());
  CHECK(file.err == "halftone: sent to file:c, which gives no picture back: no PNG\n");
  CHECK(scratch.names() == std::vector<std::string>{"c", "s.png", "s.toml", "screen.png"});
  const Outcome pipe = run_halftone({"render", "s.toml", "--device", "pipe:"}, {.folder = scratch.path()});
  CHECK(pipe.exit_code == 0);
  CHECK((pipe.out == contents(scratch / "c")));
  CHECK((screen_of(pipe.out) == png::read(scratch / "screen.png").rgb));
}

TEST_CASE("what a one-way device cannot give is refused, with advice, before anything is written") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const auto refused = [&](const std::vector<std::string>& options, const std::string& message) {
    std::vector<std::string> arguments{"render", "s.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_halftone(arguments, {.folder = scratch.path()});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err == "halftone: " + message + "\n");
    CHECK(outcome.out.empty());
    CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
  };
  refused({"--device", "file:c", "-o", "p.png"},
          "-o: file:c only takes commands, and gives no picture back; the picture in them is read with: m508 "
          "replay c -o OUT.png");
  refused({"--device", "pipe:", "--screen", "p.png"},
          "--screen: pipe: only takes commands, and gives no picture back; the picture in them is read with: "
          "m508 replay FILE -o OUT.png");
  refused({"--device", "pipe:", "--stats"}, "--stats: standard output is for the commands");
  refused({"--device", "pipe:", "--json"}, "--json: standard output is for the commands");
  refused({"--device", "file:s.toml"}, "--device s.toml: is an input, which would be lost");
  refused({"--record", "s.png"}, "--record s.png: is what -o writes, which would be lost");
}

TEST_CASE("a device that is not there is exit code 5, a file that cannot be written 4") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const auto render = [&](const std::string& device) {
    return run_halftone({"render", "s.toml", "--device", device}, {.folder = scratch.path()});
  };
  CHECK(render("unix:none").exit_code == 5);
  CHECK(render("tcp:no-such-host.invalid:1").exit_code == 5);
  CHECK(render("file:none/c").exit_code == 4);
  CHECK(run_halftone({"render", "s.toml", "--record", "none/t"}, {.folder = scratch.path()}).exit_code == 4);
  CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
}

TEST_CASE("where the disk is full, commands for a file are exit code 4, and the file is as it was") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  scratch.write("c", "old");
  const test::FullDisk full(100);
  const Outcome outcome =
      run_halftone({"render", "s.toml", "--device", "file:c"}, {.folder = scratch.path()});
  CHECK(outcome.exit_code == 4);
  CHECK(outcome.err == "halftone: c: cannot be written: File too large\n");
  CHECK(contents(scratch / "c") == "old");
  CHECK(scratch.names() == std::vector<std::string>{"c", "s.toml"});
}

TEST_CASE("a recording of a render replays to its screen") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  REQUIRE(run_halftone({"render", "s.toml", "--screen", "screen.png", "--record", "t.m508"},
                       {.folder = scratch.path()})
              .exit_code == 0);
  const recording::Trace trace = recording::read_file(scratch / "t.m508");
  const auto states = std::ranges::count_if(trace.records, [](const recording::Record& record) {
    return std::holds_alternative<recording::State>(record);
  });
  CHECK(states > 0);
  recording::Walk walk(trace, recording::States::compared);
  while (walk.next()) {
  }
  CHECK((device::screen(walk.device()) == png::read(scratch / "screen.png").rgb));
  CHECK(walk.device().registers.errors == 0);
  CHECK_FALSE(walk.departure());
}
