#include "server_process.h"
#include "support/scratch.h"

#include <halftone/device/port.h>
#include <halftone/device/screen.h>
#include <halftone/driver/driver.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <span>
#include <string>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

using namespace halftone;
using namespace std::chrono_literals;

namespace {

/// A figure of the paper, as a picture to send.
png::Picture figure() { return png::read(HALFTONE_SOURCE_DIR "/tests/golden/fig9a.png"); }

void send(driver::Driver& driver, const png::Picture& picture) {
  driver.begin(picture.width, picture.height);
  const std::size_t row = static_cast<std::size_t>(picture.width) * 3;
  for (int y = 0; y < picture.height; ++y)
    driver.send_row(y, std::span(picture.rgb).subspan(static_cast<std::size_t>(y) * row, row));
  driver.finish();
}

void send(const std::string& address, const png::Picture& picture) {
  const auto link = link::open(address, 5s);
  driver::Driver driver(*link, 5s);
  send(driver, picture);
  link->finish();
}

/// The screen of a device that these commands were sent to.
device::Bytes screen_of(const std::string& commands) {
  device::Port port;
  device::Bytes replies;
  port.receive({reinterpret_cast<const std::uint8_t*>(commands.data()), commands.size()}, replies);
  port.end(replies);
  CHECK(replies.empty()); // one way: nothing is asked
  CHECK(port.device.registers.errors == 0);
  return device::screen(port.device);
}

/// What is sent to standard output while a picture goes there.
std::string sent_to_pipe(const png::Picture& picture) {
  std::array<int, 2> ends{};
  REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
  std::string commands;
  std::thread reader([&] {
    std::array<char, 1 << 16> buffer;
    for (ssize_t count = 0; (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;)
      commands.append(buffer.data(), static_cast<std::size_t>(count));
  });
  const int out = ::dup(STDOUT_FILENO);
  ::dup2(ends[1], STDOUT_FILENO);
  ::close(ends[1]);
  send("pipe:", picture);
  ::dup2(out, STDOUT_FILENO);
  ::close(out);
  reader.join();
  ::close(ends[0]);
  return commands;
}

} // namespace

TEST_CASE("a figure gives the same screen over all five transports") {
  const test::Scratch scratch;
  const png::Picture picture = figure();

  const auto memory = link::open("mem:");
  driver::Driver driver(*memory, 5s);
  send(driver, picture);
  const device::Bytes screen = driver.read_screen();
  const driver::Placement place = driver::centred(picture.width, picture.height);
  const auto at = static_cast<std::ptrdiff_t>((place.top + picture.height / 2) * 512 + place.left) * 3;
  REQUIRE(std::equal(screen.begin() + at, screen.begin() + at + picture.width * 3,
                     picture.rgb.begin() + picture.height / 2 * picture.width * 3));

  send("file:" + scratch / "commands", picture);
  const std::string commands = test::contents(scratch / "commands");
  CHECK((screen_of(commands) == screen));
  const std::string piped = sent_to_pipe(picture);
  CHECK((piped == commands));
  CHECK((screen_of(piped) == screen));

  for (const std::string& address : {"unix:" + scratch / "s", std::string("tcp:127.0.0.1:0")}) {
    test::ServerProcess server({"--listen", address, "--once", "-o", scratch / "p.png"});
    send(server.address(), picture);
    CHECK(server.wait() == 0);
    CHECK((png::read(scratch / "p.png").rgb == screen));
  }
}

TEST_CASE("one stream gives one screen over sockets, in pieces of any size") {
  const test::Scratch scratch;
  send("file:" + scratch / "commands", figure());
  const std::string commands = test::contents(scratch / "commands");
  const device::Bytes screen = screen_of(commands);
  for (const std::size_t piece : {1UL, 13UL, 4111UL, 1'000'000UL}) {
    test::ServerProcess server({"--listen", "unix:" + scratch / "s", "--once", "-o", scratch / "p.png"});
    {
      const auto link = link::open(server.address(), 5s);
      const std::size_t size = piece == 1 ? 50'000 : commands.size(); // a byte at a time takes its time
      std::string_view rest = std::string_view(commands).substr(0, size);
      for (; !rest.empty(); rest.remove_prefix(std::min(piece, rest.size())))
        link->send({reinterpret_cast<const std::uint8_t*>(rest.data()), std::min(piece, rest.size())});
      rest = std::string_view(commands).substr(size);
      link->send({reinterpret_cast<const std::uint8_t*>(rest.data()), rest.size()});
    }
    INFO("pieces of " << piece);
    CHECK(server.wait() == 0);
    CHECK((png::read(scratch / "p.png").rgb == screen));
  }
}
