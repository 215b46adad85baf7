#include "served.h"
#include "x_server.h"

#include "support/comes_true.h"
#include "support/messages.h"
#include "support/scratch.h"
#include "support/skip.h"

#include <halftone/link/address.h>
#include <halftone/link/link.h>
#include <halftone/link/socket.h>
#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;
using test::comes_true;
using test::Running;

namespace {

bool is_possible() {
  if (!test::are_there({"websockify"}, {"web", "vnc"}, "novnc, websockify, libvncserver-dev")) return false;
  if (std::filesystem::exists("/usr/share/novnc/vnc.html")) return true;
  test::skip("/usr/share/novnc is not there (Debian: novnc)");
  return false;
}

std::vector<std::string> serve(const std::string& where) {
  return {HALFTONE_M508, "serve", "--display", "web" + where, "--listen", "unix:s"};
}

/// "HOST:PORT" of a page's address.
std::string host_and_port(const std::string& url) {
  const std::string scheme = "http://";
  return url.substr(scheme.size(), url.find('/', scheme.size()) - scheme.size());
}

bool is_answered(const std::string& place) {
  try {
    link::connect(std::get<link::TcpAddress>(link::parse_address("tcp:" + place)), 1s);
    return true;
  } catch (const link::DeviceError&) {
    return false;
  }
}

/// Its process id: the server has no other child.
int websockify_of(const Running& server) {
  const std::string process = std::to_string(server.number());
  const std::string number = test::contents("/proc/" + process + "/task/" + process + "/children");
  return number.empty() ? 0 : std::stoi(number);
}

/// A middle of so many pixels.
png::Picture middle_of(const png::Picture& picture, int width, int height) {
  png::Picture middle{width, height, {}};
  const int left = (picture.width - width) / 2, top = (picture.height - height) / 2;
  for (int y = top; y < top + height; ++y) {
    const auto row = picture.rgb.begin() + 3 * (y * picture.width + left);
    middle.rgb.insert(middle.rgb.end(), row, row + 3 * width);
  }
  return middle;
}

/// A program of the name websockify that does this.
void pretend(const test::Scratch& scratch, const std::string& script) {
  std::filesystem::create_directory(scratch / "bin");
  const std::string file = scratch.write("bin/websockify", "#!/bin/sh\n" + script);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

} // namespace

TEST_CASE("headless Chromium shows the device's screen") {
  if (!is_possible() || !test::are_there({"chromium", "python3"}, {}, "chromium, python3")) return;
  const test::Scratch scratch;
  Running server(serve(":127.0.0.1:0"), scratch.path());
  const std::string url = test::address_in(scratch / "out", "web");
  REQUIRE(url.starts_with("http://127.0.0.1:"));
  const auto link = link::open("unix:" + scratch / "s");
  test::send_noise(*link);
  const png::Picture screen{512, 512, test::screen_of(*link)};
  std::filesystem::create_directory(scratch / "browser");
  Running browser({"python3", HALFTONE_SOURCE_DIR "/tests/display/browser.py", url, "page.png", "900", "700"},
                  scratch / "browser");
  const std::string page = scratch / "browser/page.png";
  const auto shows = [&](const png::Picture& wanted, std::chrono::milliseconds patience) {
    return comes_true(
        [&] { return std::filesystem::exists(page) && middle_of(png::read(page), 512, 512) == wanted; },
        patience);
  };
  // A browser that is started for the first time on a busy machine takes its time.
  CHECK(shows(screen, 60s));
  // And what comes later.
  link->send(test::bytes_of({{protocol::Opcode::window, 6, {100, 200, 300, 3}, {}},
                             {protocol::Opcode::pixels, 7, {}, device::Bytes(900, 128)}}));
  const png::Picture later{512, 512, test::screen_of(*link)};
  REQUIRE(later != screen);
  CHECK(shows(later, 15s));
  browser.send(SIGTERM);
  CHECK(browser.wait() == 0);
  server.send(SIGTERM);
  CHECK(server.wait() == 0);
}

TEST_CASE("websockify ends with the display, also when that is killed") {
  if (!is_possible()) return;
  for (const int signal : {SIGTERM, SIGKILL}) {
    const test::Scratch scratch;
    Running server(serve(":127.0.0.1:0"), scratch.path());
    const std::string place = host_and_port(test::address_in(scratch / "out", "web"));
    CAPTURE(signal, place);
    REQUIRE(is_answered(place));
    server.send(signal);
    CHECK(server.wait() == (signal == SIGTERM ? 0 : -1));
    CHECK(comes_true([&] { return !is_answered(place); }));
  }
}

TEST_CASE("without websockify the web display is gone, and says so") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  Running server(serve(":127.0.0.1:0"), scratch.path());
  REQUIRE_FALSE(test::address_in(scratch / "out", "web").empty());
  const int websockify = websockify_of(server);
  REQUIRE(websockify > 1);
  ::kill(websockify, SIGKILL);
  CHECK(server.wait() == 4);
  CHECK(test::contents(scratch / "err").starts_with("m508: display web: websockify has ended"));
}

TEST_CASE("a missing websockify is told with its package") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  Running server(serve(":127.0.0.1:0"), scratch.path(), {"PATH=" + scratch.path().string()});
  CHECK(server.wait() == 4);
  CHECK(test::contents(scratch / "err") ==
        "m508: display web: websockify is not on PATH; install websockify\n");
}

TEST_CASE("a websockify that does not start is told in its own words") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  pretend(scratch, "echo one word >&2\necho No module named numpy >&2\nexit 1\n");
  Running server(serve(":127.0.0.1:0"), scratch.path(), {"PATH=" + scratch / "bin"});
  CHECK(server.wait() == 4);
  CHECK(test::contents(scratch / "err") ==
        "m508: display web: websockify did not start: No module named numpy\n");
}

// The display asks once a second whether it is served; the socket holds seventeen who are not listened to.
TEST_CASE("a websockify that never answers is given up", "[.][long]") {
  if (!is_possible()) return;
  const test::Scratch scratch;
  pretend(scratch, "exec /bin/sleep 300\n");
  Running server(serve(":127.0.0.1:0"), scratch.path(), {"PATH=" + scratch / "bin"});
  CHECK(server.wait(30s) == 4);
  CHECK(test::contents(scratch / "err") == "m508: display web: websockify does not answer\n");
}

TEST_CASE("a browser's port that is taken is one line and exit code 4") {
  if (!is_possible()) return;
  const test::Scratch scratch, other;
  Running server(serve(":127.0.0.1:0"), scratch.path());
  const std::string place = host_and_port(test::address_in(scratch / "out", "web"));
  Running second(serve(':' + place), other.path());
  CHECK(second.wait() == 4);
  CHECK(test::contents(other / "err") ==
        "m508: display web: cannot listen on " + place +
            ": another process listens there; port 0 takes one that is free\n");
}
