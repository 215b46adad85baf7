#include "server_process.h"
#include "support/scratch.h"

#include <halftone/device/screen.h>
#include <halftone/png/png.h>
#include <halftone/protocol/checksum.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/wait.h>

using namespace halftone;
using test::Scratch;
using test::ServerProcess;

namespace {

bool has_python() { return std::system("python3 -c pass > /dev/null 2>&1") == 0; }

struct Outcome {
  int exit_code = -1;
  std::string text; ///< stdout and stderr
};

Outcome run(const std::string& command) {
  Outcome outcome;
  std::FILE* out = ::popen((command + " 2>&1").c_str(), "r");
  REQUIRE(out != nullptr);
  for (int character = 0; (character = std::fgetc(out)) != EOF;) outcome.text += static_cast<char>(character);
  const int status = ::pclose(out);
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  return outcome;
}

/// The client writes what it expects of its recording to the file of checks.
Outcome run_client(const std::string& address, const std::string& checks) {
  return run("timeout 60 python3 '" HALFTONE_SOURCE_DIR "/tests/serve/m508_client.py' '" + address + "' '" +
             checks + "'");
}

/// m508 COMMAND RECORDING ARGUMENTS, as a user asks about a recording.
Outcome ask(const std::string& command, const std::string& recording, const std::string& arguments = {}) {
  return run("'" HALFTONE_M508 "' " + command + " '" + recording + "' " + arguments);
}

std::string hexadecimal(std::uint32_t number) {
  char text[9];
  std::snprintf(text, sizeof text, "%08X", number);
  return text;
}

} // namespace

TEST_CASE("a client in another language draws, verifies, and its recording replays to the same screen") {
  REQUIRE(has_python());
  const Scratch scratch;
  for (const std::string& place : {"unix:" + scratch / "s", std::string("tcp:127.0.0.1:0")}) {
    ServerProcess server(
        {"--listen", place, "--once", "-o", scratch / "p.png", "--record", scratch / "t.m508"});
    const Outcome client = run_client(server.address(), scratch / "checks.toml");
    INFO(client.text);
    REQUIRE(client.exit_code == 0);
    CHECK(server.wait() == 0);

    const recording::Trace trace = recording::read_file(scratch / "t.m508");
    recording::Walk walk(trace, recording::States::compared);
    while (walk.next()) {
    }
    CHECK_FALSE(walk.departure());
    const device::Bytes screen = device::screen(walk.device());
    CHECK((png::read(scratch / "p.png").rgb == screen));
    CHECK_THAT(client.text, Catch::Contains("screen: " + hexadecimal(protocol::checksum(screen))));
  }
}

TEST_CASE("who, lint and assert answer about the recording of a client in another language") {
  REQUIRE(has_python());
  const Scratch scratch;
  const std::string recorded = scratch / "t.m508", checks = scratch / "checks.toml";
  ServerProcess server({"--listen", "unix:" + scratch / "s", "--once", "--record", recorded});
  const Outcome client = run_client(server.address(), checks);
  INFO(client.text);
  REQUIRE(client.exit_code == 0);
  REQUIRE(server.wait() == 0);

  // The fill went through a write mask: the upper half of red, all of green, nothing of blue.
  CHECK(ask("who", recorded, "205 205 --plane image0").text ==
        "image0 (205, 205) after 363 commands: 95 18 128\n"
        "last written by command 318 (byte 364207, session 1, sequence 317, section \"mask\")\n"
        "  fill x=200 y=200 width=40 height=30 red=90 green=18 blue=255\n"
        "  95 116 128 -> 95 18 128\n"
        "other commands that addressed it, newest first\n"
        "  command 149 (byte 166365, session 1, sequence 148, section \"painting\")\n"
        "    pixels 007480*2 017480*2 027480 037480*2 ... (400 pixels)\n"
        "    0 0 0 -> 95 116 128\n"
        "  command 9 (byte 129, session 1, sequence 8, section \"errors\")\n"
        "    reset\n"
        "    0 0 0 -> 0 0 0\n");
  // Copied twice, the second time onto itself; seen by zoom, pan and the other buffer.
  const Outcome copied = ask("who", recorded, "180 120");
  CHECK(copied.exit_code == 0);
  CHECK_THAT(copied.text,
             Catch::StartsWith(
                 "at screen (180, 120) after 363 commands lies image1 (33, 38): 83 106 128\n"
                 "but the look-up tables make 172 106 128\n"
                 "last written by command 325 (byte 364342, session 1, sequence 324, section \"copy\")\n"
                 "  copy x=20 y=30 width=120 height=60 to_x=27 to_y=35 from=1\n"
                 "  87 110 128 -> 83 106 128\n"
                 "other commands that addressed it, newest first\n"
                 "  command 324 (byte 364316, session 1, sequence 323, section \"copy\")\n"
                 "    copy x=180 y=190 width=120 height=60 to_x=20 to_y=30 from=0\n"
                 "    0 0 0 -> 87 110 128\n"));
  CHECK_THAT(ask("who", recorded, "3 200").text,
             Catch::Contains("but the border covers it: 64 65 66 is seen\n"));
  CHECK_THAT(ask("who", recorded, "40 104").text,
             Catch::Contains("but the cursor covers it: 250 251 252 is seen\n"));
  CHECK_THAT(ask("who", recorded, "45 108").text,
             Catch::Contains("but the overlay covers it: 255 255 0 is seen; ask who wrote that with --plane "
                             "overlay 45 108\n"));

  // It made one error of each kind on purpose, and cleared a fill at once; nothing else looks like a mistake.
  const Outcome lint = ask("lint", recorded);
  CHECK(lint.exit_code == 1);
  for (const std::string line :
       {"command 3: warning: fill, out of limits: ", "command 4: warning: 0x7f, unknown opcode: ",
        "command 5: warning: zoom, wrong length: ", "command 6: warning: 11 damaged bytes: ",
        "command 322: warning: fill x=0 y=0 width=9 height=9 red=1 green=2 blue=3: 81 of its 81 pixels "
        "overwritten "
        "before they were seen, first by command 323; "})
    CHECK_THAT(lint.text, Catch::Contains(line));
  CHECK_THAT(lint.text, Catch::EndsWith("\n5 warnings, 0 notes: 4 rejected, 1 never-seen\n"));

  const Outcome all = ask("assert", recorded, "'" + checks + "'");
  CHECK(all.exit_code == 0);
  CHECK_THAT(all.text, Catch::EndsWith("checks hold\n") && !Catch::Contains("FAIL"));
  const std::string wrong_checks = scratch.write(
      "wrong.toml", "[[check]]\nplane = \"image0\"\npixel = [205, 205]\ncolor = [90, 18, 255]\n");
  const Outcome wrong = ask("assert", recorded, '\'' + wrong_checks + '\'');
  CHECK(wrong.exit_code == 1);
  CHECK_THAT(wrong.text, Catch::Contains("pixel (205, 205): found 95 18 128, expected 90 18 255"));
}
