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

using namespace halftone;
using test::Scratch;
using test::ServerProcess;

namespace {

bool has_python() { return std::system("python3 -c pass > /dev/null 2>&1") == 0; }

struct Outcome {
  int exit_code = -1;
  std::string text; ///< stdout and stderr
};

Outcome run_client(const std::string& address) {
  const std::string command =
      "timeout 60 python3 '" HALFTONE_SOURCE_DIR "/tests/serve/m508_client.py' '" + address + "' 2>&1";
  Outcome outcome;
  std::FILE* client = ::popen(command.c_str(), "r");
  for (int character = 0; (character = std::fgetc(client)) != EOF;)
    outcome.text += static_cast<char>(character);
  outcome.exit_code = ::pclose(client);
  return outcome;
}

std::string hexadecimal(std::uint32_t number) {
  char text[9];
  std::snprintf(text, sizeof text, "%08X", number);
  return text;
}

} // namespace

TEST_CASE("a client in another language draws, verifies, and its recording replays to the same screen") {
  if (!has_python()) {
    WARN("skipped: no python3 here");
    return;
  }
  const Scratch scratch;
  for (const std::string& place : {"unix:" + scratch / "s", std::string("tcp:127.0.0.1:0")}) {
    ServerProcess server(
        {"--listen", place, "--once", "-o", scratch / "p.png", "--record", scratch / "t.m508"});
    const Outcome client = run_client(server.address());
    INFO(client.text);
    REQUIRE(client.exit_code == 0);
    CHECK(server.wait() == 0);

    const recording::Trace trace = recording::read_file(scratch / "t.m508");
    recording::Walk walk(trace);
    while (walk.next()) {
    }
    CHECK_FALSE(walk.departure());
    const device::Bytes screen = device::screen(walk.device());
    CHECK((png::read(scratch / "p.png").rgb == screen));
    CHECK_THAT(client.text, Catch::Contains("screen: " + hexadecimal(protocol::checksum(screen))));
  }
}
