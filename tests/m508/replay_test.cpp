#include "run.h"

#include <halftone/device/port.h>
#include <halftone/device/screen.h>
#include <halftone/device/snapshot.h>
#include <halftone/png/png.h>
#include <halftone/protocol/text.h>
#include <halftone/recording/text.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <chrono>

using namespace halftone;
using test::run_m508;
using test::Scratch;

namespace {

const std::string picture_text = "fill x=10 y=20 width=30 height=40 red=255 green=128 blue=0\n"
                                 "mark \"half\"\n"
                                 "frame 0x77\n"
                                 "wait fields=2\n"
                                 "fill x=200 y=200 width=30 height=40 red=9 green=8 blue=7\n"
                                 "ramp channels=1 first=0 count=256 from=255 to=0\n"
                                 "border thickness=3 red=1 green=2 blue=3\n";

/// The device that has executed so many lines of the text.
device::Device after(int lines) {
  std::string text;
  std::size_t end = 0;
  while (lines-- > 0) end = picture_text.find('\n', end) + 1;
  device::Port port;
  device::Bytes replies;
  port.receive(protocol::assemble(std::string_view(picture_text).substr(0, end)), replies);
  return port.device;
}

void write_stream(const Scratch& scratch) {
  scratch.write("a", test::as_text(protocol::assemble(picture_text)));
}

bool says(const test::Outcome& outcome, const std::string& line) {
  return outcome.out.find(line + "\n") != std::string::npos;
}

} // namespace

TEST_CASE("replay writes the screen in the end, in memory, and after the look-up tables") {
  const Scratch scratch;
  write_stream(scratch);
  const device::Device device = after(7);
  REQUIRE(run_m508(scratch, {"replay", "a", "-o", "shown.png"}).exit_code == 0);
  CHECK(png::read(scratch / "shown.png").rgb == device::screen(device));
  REQUIRE(run_m508(scratch, {"replay", "a", "--as", "raw", "-o", "raw.png"}).exit_code == 0);
  CHECK(png::read(scratch / "raw.png").rgb == device.images[0]);
  REQUIRE(run_m508(scratch, {"replay", "a", "--as", "lut", "-o", "lut.png"}).exit_code == 0);
  device::Device without_border = device;
  without_border.registers.border = 0;
  CHECK(png::read(scratch / "lut.png").rgb == device::screen(without_border));
}

TEST_CASE("replay stops after a command, at a mark, and in a field") {
  const Scratch scratch;
  write_stream(scratch);
  const auto commands = [&](const std::string& until) {
    const auto outcome = run_m508(scratch, {"replay", "a", "--until", until, "-o", "x.png"});
    INFO(until << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const int count = std::stoi(outcome.out.substr(outcome.out.find("commands") + 8));
    CHECK(png::read(scratch / "x.png").rgb == device::screen(after(count)));
    return count;
  };
  CHECK(commands("0") == 0);
  CHECK(commands("5") == 5);
  CHECK(commands("mark:half") == 2);
  CHECK(commands("frame:0") == 0);
  CHECK(commands("frame:2") == 4);
}

TEST_CASE("replay writes pictures on the way") {
  const Scratch scratch;
  write_stream(scratch);
  REQUIRE(run_m508(scratch, {"replay", "a", "--each", "3", "-o", "x.png"}).exit_code == 0);
  CHECK(scratch.names() == std::vector<std::string>{"a", "x-00000003.png", "x-00000006.png", "x.png"});
  CHECK(png::read(scratch / "x-00000006.png").rgb == device::screen(after(6)));
}

TEST_CASE("replay counts what was rejected, and goes on") {
  const Scratch scratch;
  write_stream(scratch);
  const auto outcome = run_m508(scratch, {"replay", "a"});
  CHECK(outcome.exit_code == 0);
  CHECK(says(outcome, "commands   7"));
  CHECK(says(outcome, "rejected   1"));
  CHECK(outcome.err == "m508: a: 1 of 7 commands were rejected, the first of them 3: unknown opcode\n");
}

TEST_CASE("replay exits with 1 where the device is not as it was recorded") {
  const Scratch scratch;
  const auto run = [&](std::uint32_t checksum) {
    scratch.write("a", test::as_text(encode(recording::assemble(
                           ".trace version=1 profile=0 bus=\"b\" byte_picoseconds=0 frame_picoseconds=0\n"
                           "clear\n.state commands=1 checksum=" +
                           std::to_string(checksum) + "\n"))));
    return run_m508(scratch, {"replay", "a", "-o", "x.png"});
  };
  CHECK(run(device::state_checksum({})).exit_code == 0);
  const auto outcome = run(7);
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, Catch::StartsWith("m508: a: after command 1 this device has state "));
  CHECK_THAT(outcome.err, Catch::Contains("the recorded one had state 00000007 after command 1; no "
                                          "state before it was recorded"));
}

TEST_CASE("a replay on another bus takes that bus's time, and the time itself if it is to") {
  const Scratch scratch;
  scratch.write("a", test::as_text(protocol::assemble("zeros 1\npixels 000000*600\n")));
  for (const std::vector<std::string>& display : {std::vector<std::string>{}, {"--display", "none"}}) {
    std::vector<std::string> arguments{"replay", "a", "--bus", "rs232", "--pace"};
    arguments.insert(arguments.end(), display.begin(), display.end());
    const auto began = std::chrono::steady_clock::now();
    const auto outcome = run_m508(scratch, arguments);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    // 1,813 bytes of 520,833,333 ps, 10 us for a command and 400 ns for each of 600 pixels
    CHECK(says(outcome, "seconds    0.944521"));
    CHECK(took.count() >= 0.94);
  }
}

TEST_CASE("standard input is read where the file is a hyphen") {
  const Scratch scratch;
  const auto outcome = run_m508(scratch, {"replay", "-"});
  CHECK(outcome.exit_code == 0);
  CHECK(says(outcome, "commands   0"));
}
