#include "rfb_client.h"
#include "served.h"
#include "x_server.h"

#include "support/comes_true.h"
#include "support/effort.h"
#include "support/scratch.h"

#include <halftone/display/open.h>
#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

using namespace halftone;
using namespace std::chrono_literals;
using display::screen_height;
using test::comes_true;
using test::RfbClient;
using test::Running;

namespace {

constexpr std::size_t row_size = static_cast<std::size_t>(display::screen_width) * 3;

/// The display as a program has it, with pictures that the test makes.
struct Vnc {
  Vnc() : display(display::open({"vnc", "127.0.0.1:0"}, {HALFTONE_MODULES})), rgb(row_size * screen_height) {
    for (int y = 0; y < screen_height; ++y) paint(y, y * 7);
  }

  /// Other pixels for a row, all of whose bytes differ from before.
  void paint(int y, int seed) {
    for (std::size_t i = 0; i < row_size; ++i)
      rgb[static_cast<std::size_t>(y) * row_size + i] =
          static_cast<std::uint8_t>(static_cast<std::size_t>(seed) + i * 3 + i / 255);
  }

  void show(int first = 0, int count = screen_height) { display->show({rgb, {first, count}}); }

  RfbClient client() {
    return RfbClient(display->address(), [this] { display->poll(); });
  }

  /// One that has the picture.
  RfbClient looking_client() { return looking(client()); }

  RfbClient looking(RfbClient looking) {
    looking.shake_hands();
    looking.ask(false);
    looking.take_update();
    REQUIRE(looking.rgb() == rgb);
    return looking;
  }

  std::unique_ptr<display::Display> display;
  std::vector<std::uint8_t> rgb;
};

bool is_possible() { return test::are_there({}, {"vnc"}, "libvncserver-dev"); }

using Rectangles = std::vector<RfbClient::Rectangle>;

} // namespace

TEST_CASE("gvnccapture's picture is the device's screen") {
  if (!test::are_there({"gvnccapture"}, {"vnc"}, "gvncviewer, libvncserver-dev")) return;
  const test::Scratch scratch;
  Running server(
      {HALFTONE_M508, "serve", "--display", "vnc:127.0.0.1:0", "--listen", "unix:s", "-o", "end.png"},
      scratch.path());
  const std::string address = test::address_in(scratch / "out", "vnc");
  REQUIRE(address.starts_with("127.0.0.1:"));
  {
    const auto link = link::open("unix:" + scratch / "s");
    test::send_noise(*link);
    const png::Picture screen{512, 512, test::screen_of(*link)};
    // It counts from port 5900, as VNC's displays are.
    const int number = std::stoi(address.substr(address.find(':') + 1)) - 5900;
    CHECK(comes_true([&] {
      test::printed("timeout 10 gvnccapture -q 127.0.0.1:" + std::to_string(number) + " '" +
                    scratch / "seen.png" + '\'');
      return std::filesystem::exists(scratch / "seen.png") && png::read(scratch / "seen.png") == screen;
    }));
  }
  server.send(SIGTERM);
  CHECK(server.wait() == 0);
  CHECK(png::read(scratch / "seen.png") == png::read(scratch / "end.png"));
}

TEST_CASE("VNC sends the rows that changed and no others") {
  if (!is_possible()) return;
  Vnc vnc;
  vnc.show();
  RfbClient client = vnc.looking_client();
  for (const int y : {100, 101, 102, 300}) vnc.paint(y, 5 * y + 1);
  vnc.show(90, 300);
  client.ask(true);
  CHECK(client.take_update() == Rectangles{{0, 100, 512, 3}, {0, 300, 512, 1}});
  CHECK(client.rgb() == vnc.rgb);

  client.ask(true);
  vnc.show(); // nothing has changed
  CHECK_FALSE(client.hears_something(100));
  vnc.paint(511, 3);
  vnc.show(511, 1);
  CHECK(client.take_update() == Rectangles{{0, 511, 512, 1}});
  CHECK(client.rgb() == vnc.rgb);
}

TEST_CASE("who was slow gets what changed meanwhile at once") {
  if (!is_possible()) return;
  Vnc vnc;
  vnc.show();
  RfbClient client = vnc.looking_client();
  for (int i = 0; i < 50; ++i) {
    vnc.paint(200 + i % 3, 11 * i + 2);
    vnc.show(200 + i % 3, 1);
  }
  std::this_thread::sleep_for(50ms);
  client.ask(true);
  CHECK(client.take_update() == Rectangles{{0, 200, 512, 3}});
  CHECK(client.rgb() == vnc.rgb);
}

TEST_CASE("what VNC has shown does not stay in memory", test::long_when_sanitized) {
  if (!is_possible()) return;
  const test::Scratch scratch;
  Running server({HALFTONE_M508, "serve", "--display", "vnc:127.0.0.1:0", "--listen", "unix:s"},
                 scratch.path());
  REQUIRE_FALSE(test::address_in(scratch / "out", "vnc").empty());
  const auto link = link::open("unix:" + scratch / "s");
  const auto memory = [&] { // resident, in bytes
    std::ifstream numbers("/proc/" + std::to_string(server.number()) + "/statm");
    std::size_t size = 0, resident = 0;
    numbers >> size >> resident;
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  };
  const auto send = [&](int times) { // 1.6 MB each time
    for (int i = 0; i < times; ++i) {
      test::send_noise(*link);
      test::screen_of(*link);
    }
  };
  send(4);
  const std::size_t before = memory();
  send(40);
  CHECK(memory() < before + 30'000'000);
}

TEST_CASE("no client is served before there is a picture") {
  if (!is_possible()) return;
  Vnc vnc;
  RfbClient early = vnc.client();
  vnc.display->poll();
  CHECK_FALSE(early.hears_something(200));
  vnc.show();
  early.shake_hands();
  early.ask(false);
  early.take_update();
  CHECK(early.rgb() == vnc.rgb);
}

TEST_CASE("a client that stops reading, or dies, holds up nobody") {
  if (!is_possible()) return;
  Vnc vnc;
  vnc.show();
  RfbClient stuck = vnc.looking_client();
  for (int i = 0; i < 30; ++i) stuck.ask(false); // 30 MB, of which it takes none
  std::optional<RfbClient> dying(vnc.looking_client());
  dying->ask(false);
  dying->send("\3\1"); // a part of a question
  dying.reset();
  std::optional<RfbClient> silent(vnc.client());

  const auto begin = std::chrono::steady_clock::now();
  RfbClient other = vnc.looking_client();
  for (int i = 0; i < 100; ++i) {
    vnc.paint(i, 13 * i + 4);
    vnc.show(i, 1);
    vnc.display->poll();
  }
  comes_true([&] {
    other.ask(true);
    other.take_update();
    return other.rgb() == vnc.rgb;
  });
  CHECK(other.rgb() == vnc.rgb);
  vnc.display.reset();                                   // nor does it hold up the end
  CHECK(std::chrono::steady_clock::now() - begin < 10s); // libvncserver itself waits for 20
}

TEST_CASE("sixteen people can look at once, and one more when one leaves") {
  if (!is_possible()) return;
  Vnc vnc;
  vnc.show();
  std::vector<RfbClient> clients;
  for (int i = 0; i < 16; ++i) clients.push_back(vnc.looking_client());
  RfbClient one_more = vnc.client();
  CHECK(comes_true([&] {
    vnc.display->poll();
    return one_more.is_closed();
  }));
  clients.erase(clients.begin() + 3);
  // A seat is free when the server has seen that somebody has gone.
  std::optional<RfbClient> next;
  REQUIRE(comes_true([&] {
    next.emplace(vnc.client());
    const bool hears = comes_true([&] {
      vnc.display->poll();
      return next->hears_something(0);
    });
    return hears && !next->is_closed();
  }));
  clients.push_back(vnc.looking(std::move(*next)));
  vnc.paint(9, 1);
  vnc.show(9, 1);
  for (RfbClient& client : clients) {
    client.ask(true);
    client.take_update();
    CHECK(client.rgb() == vnc.rgb);
  }
}

TEST_CASE("who looks by VNC can do nothing, and no cursor is drawn") {
  if (!is_possible()) return;
  Vnc vnc;
  vnc.show();
  RfbClient client = vnc.looking_client();
  client.send(std::string("\5\1\1\0\1\0", 6));         // left button, at 256, 256
  client.send(std::string("\4\1\0\0\0\0\0\161", 8));   // key q
  client.send(std::string("\6\0\0\0\0\0\0\3cut", 11)); // clipboard
  client.ask(false);
  client.take_update();
  CHECK(client.rgb() == vnc.rgb);
  CHECK(vnc.display->poll().empty());
}

TEST_CASE("the title is the desktop's name") {
  if (!is_possible()) return;
  Vnc vnc;
  vnc.display->say({"m508 on unix:s", "", 1, {}});
  vnc.show();
  CHECK(vnc.looking_client().title() == "m508 on unix:s");
}

TEST_CASE("VNC on a port that is taken is one line and exit code 4") {
  if (!is_possible()) return;
  const Vnc vnc;
  const std::string address = vnc.display->address();
  const test::Scratch scratch;
  Running server({HALFTONE_M508, "serve", "--display", "vnc:" + address, "--listen", "unix:s"},
                 scratch.path());
  CHECK(server.wait() == 4);
  CHECK(test::contents(scratch / "err") ==
        "m508: display vnc: cannot listen on " + address +
            ": another process listens there; port 0 takes one that is free\n");
  CHECK(test::contents(scratch / "out").empty());
}

TEST_CASE("an address that VNC does not understand is a bad argument") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  for (const std::string where : {"5901", "127.0.0.1", "127.0.0.1:", "127.0.0.1:70000", "::1:5900"}) {
    Running server({HALFTONE_M508, "serve", "--display", "vnc:" + where, "--listen", "unix:s"},
                   scratch.path());
    CAPTURE(where);
    CHECK(server.wait() == 2);
    CHECK(test::contents(scratch / "err").starts_with("m508: --display: display vnc: "));
    CHECK(test::contents(scratch / "err").ends_with("; found \"" + where + "\"\n"));
  }
}
