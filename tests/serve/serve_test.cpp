#include "client.h"
#include "server_process.h"

#include <halftone/device/device.h>
#include <halftone/driver/driver.h>
#include <halftone/png/png.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <sys/socket.h>

using namespace halftone;
using namespace std::chrono_literals;
using protocol::Message;
using protocol::Opcode;
using test::ask;
using test::bytes_of;
using test::color_at_origin;
using test::places;
using test::Scratch;
using test::ServerProcess;
using test::whole_read;
using Bytes = std::vector<std::uint8_t>;

namespace {

const Message red_fill{Opcode::fill, 1, {0, 0, 512, 512, 255, 0, 0}, {}};
const Message status{Opcode::status, 3, {}, {}};

bool is_all_red(const std::string& png) {
  const png::Picture picture = png::read(png);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    if (picture.rgb[i] != (i % 3 == 0 ? 255 : 0)) return false;
  return picture.width == 512 && picture.height == 512;
}

} // namespace

TEST_CASE("clients are served in turn, each on the picture that was left") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    const ServerProcess server({"--listen", place});
    for (std::uint32_t color = 0; color < 5; ++color) {
      const auto client = link::open(server.address(), 5s);
      CHECK(color_at_origin(*client) == color);
      client->send(bytes_of({{Opcode::fill, 1, {0, 0, 1, 1, 0, 0, color + 1}, {}}}));
    }
  }
}

TEST_CASE("a client waits until the one before it has gone") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    const ServerProcess server({"--listen", place});
    auto first = link::open(server.address(), 5s);
    CHECK(color_at_origin(*first) == 0);
    const auto second = link::open(server.address(), 5s);
    CHECK_THROWS_AS(ask(*second, status, 100ms), link::Timeout);
    first->send(bytes_of({red_fill}));
    first.reset();
    Bytes buffer(1000);
    CHECK(second->receive(buffer, 5s) > 0); // the answer to what it asked before
    CHECK(color_at_origin(*second) == 0xFF0000);
  }
}

TEST_CASE("a client that dies in mid-command leaves the picture as it was, and damage") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    const ServerProcess server({"--listen", place});
    Bytes bytes = bytes_of({red_fill, {Opcode::fill, 2, {0, 0, 512, 512, 0, 255, 0}, {}}});
    bytes.pop_back();
    link::open(server.address(), 5s)->send(bytes);
    const auto next = link::open(server.address(), 5s);
    CHECK(color_at_origin(*next) == 0xFF0000);
    const auto state = ask(*next, status);
    CHECK(state[protocol::index_of(Opcode::state, "error")] == 1); // damaged
    CHECK(state[protocol::index_of(Opcode::state, "commands")] == 1);
    CHECK(state[protocol::index_of(Opcode::state, "skipped")] == bytes.size() / 2);
  }
}

TEST_CASE("a client that has asked and ended its side gets all answers") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    const ServerProcess server({"--listen", place});
    const file::Descriptor client = test::connect(link::parse_address(server.address()));
    const Bytes bytes = bytes_of(std::vector<Message>(20, whole_read));
    REQUIRE(::send(client.number(), bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    ::shutdown(client.number(), SHUT_WR);
    std::size_t total = 0;
    Bytes buffer(100'000);
    for (const auto deadline = std::chrono::steady_clock::now() + 10s;
         std::chrono::steady_clock::now() < deadline;) {
      const ssize_t count = ::recv(client.number(), buffer.data(), buffer.size(), 0);
      if (count == 0) break;
      if (count > 0) total += static_cast<std::size_t>(count);
    }
    CHECK(total == 20 * test::whole_read_answer);
  }
}

TEST_CASE("a client that asks and asks and never listens does not grow the server") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    ServerProcess server({"--listen", place});
    const Bytes bytes = bytes_of(std::vector<Message>(1000, whole_read));
    const auto client = link::open(server.address(), 5s);
    color_at_origin(*client);
    const std::size_t before = server.peak_memory();
    client->send(bytes); // of which 786 MB would come back
    std::this_thread::sleep_for(500ms);
    CHECK(before > 0);
    CHECK(server.peak_memory() < before + 16'000'000);
    server.send(SIGTERM); // and it can still be ended
    CHECK(server.wait() == 0);
  }
}

TEST_CASE("a signal ends the server, with picture, recording and no socket left, clients or not") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Scratch scratch;
    for (const std::string& place : places(scratch)) {
      ServerProcess server({"--listen", place, "-o", scratch / "p.png", "--record", scratch / "t.m508"});
      const auto client = link::open(server.address(), 5s);
      client->send(bytes_of({red_fill}));
      CHECK(color_at_origin(*client) == 0xFF0000);
      server.send(signal);
      CHECK(server.wait() == 0);
      CHECK(server.errors().empty());
      CHECK(scratch.names() == std::vector<std::string>{"p.png", "t.m508"});
      CHECK(is_all_red(scratch / "p.png"));
      const recording::Trace trace = recording::read_file(scratch / "t.m508");
      recording::Walk walk(trace, recording::States::compared);
      while (walk.next()) {
      }
      CHECK_FALSE(walk.departure());
      CHECK(walk.device().registers.commands == 1);
      CHECK_THROWS_WITH(ask(*client, status), "the device closed the connection");
    }
  }
}

TEST_CASE("with --once the first client is the last; whoever sends nothing is none") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    ServerProcess server({"--listen", place, "--once", "-o", scratch / "p.png"});
    link::open(server.address(), 5s);
    link::open(server.address(), 5s)->send(bytes_of({red_fill}));
    CHECK(server.wait() == 0);
    CHECK(is_all_red(scratch / "p.png"));
  }
}

TEST_CASE("a killed server's socket does not keep the next from its place, a live one's does") {
  const Scratch scratch;
  const std::string place = "unix:" + scratch / "s";
  {
    const ServerProcess killed({"--listen", place});
    CHECK(killed.address() == place);
  }
  REQUIRE(scratch.names() == std::vector<std::string>{"s"});
  ServerProcess server({"--listen", place, "--once"});
  CHECK(server.address() == place);
  ServerProcess other({"--listen", place});
  CHECK(other.address().empty());
  CHECK(other.wait() == 5);
  CHECK(other.errors() == "m508: cannot listen on " + place + ": another process listens there\n");
  link::open(place, 5s)->send(bytes_of({red_fill})); // the one that asked was no client
  CHECK(server.wait() == 0);
}

TEST_CASE("what cannot be served is refused before anything is made") {
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    std::string error;
  };
  const Scratch scratch;
  scratch.write("b.toml", "[[bus]]\nname = \"x\"\n");
  for (const Case& each : std::vector<Case>{
           {{"--listen", "nonsense"}, 2, "--listen: device address \"nonsense\": not understood; "},
           {{"--listen", "mem:"}, 2, "--listen: no client could connect to \"mem:\"; "},
           {{"--display", "windows"}, 2, "--display: there is no display \"windows\"; "},
           {{"--fault", "x"}, 2, ""},
           {{"--fault", "-1"}, 2, "--fault: expected a whole number from 0 to "},
           {{"-o", "x.png", "--record", "./x.png"}, 2, "--record ./x.png: is what -o writes, which would "},
           {{"--bus", "x", "--buses", "b.toml", "--record", "b.toml"}, 2, "--record b.toml: is an input, "},
           {{"--bus", "x", "--buses", "b.toml", "-o", "b.toml"}, 2, "-o b.toml: is an input, which would "},
           {{"-o", "none/x.png"}, 4, "none/x.png: cannot be written: "},
           {{"--record", "none/x"}, 4, "none/x: cannot be written: "},
           {{"--listen", "unix:none/s"}, 5, "cannot listen on unix:none/s: "},
           {{"--listen", "tcp:no-such-host.invalid:1"}, 5, "no host \"no-such-host.invalid\""}}) {
    ServerProcess server(each.arguments, scratch.path());
    INFO(each.arguments[0] << " " << each.arguments[1]);
    CHECK(server.address().empty());
    CHECK(server.wait() == each.exit_code);
    CHECK_THAT(server.errors(), Catch::StartsWith("m508: " + each.error));
    CHECK(scratch.names() == std::vector<std::string>{"b.toml"});
  }
}

TEST_CASE("a server whose output nobody reads ends with an error and with its picture") {
  const Scratch scratch;
  ServerProcess server({"--listen", "unix:" + scratch / "s", "-o", scratch / "p.png"}, ".", false);
  CHECK(server.wait() == 4);
  CHECK(server.errors() == "m508: standard output cannot be written: nobody learns the address\n");
  CHECK(scratch.names() == std::vector<std::string>{"p.png"});
}

TEST_CASE("over a server that spoils what passes a picture arrives or an error names rows") {
  const Scratch scratch;
  ServerProcess server({"--listen", "unix:" + scratch / "s", "--fault", "1"});
  const Bytes row(60, 200);
  int right = 0;
  for (int client = 0; client < 20; ++client) {
    const auto start = std::chrono::steady_clock::now();
    Bytes received(600, 200);
    try {
      const auto link = link::open(server.address(), 400ms);
      driver::Driver driver(*link, 400ms);
      driver.begin(20, 10);
      for (int y = 0; y < 10; ++y) driver.send_row(y, row);
      driver.finish();
      received = driver.read_picture();
      ++right;
    } catch (const std::runtime_error& error) { // DeviceError, Timeout
      CHECK_THAT(error.what(), Catch::Contains(" row"));
    }
    CHECK((received == Bytes(600, 200)));
    CHECK(std::chrono::steady_clock::now() - start < 5s);
  }
  CHECK(right >= 10);
  server.send(SIGTERM);
  CHECK(server.wait() == 0);
  CHECK_THAT(server.errors(), Catch::StartsWith("m508: spoils what passes; first client: seed 1"));
}
