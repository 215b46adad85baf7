#include "picture.h"
#include "support/messages.h"

#include <halftone/driver/driver.h>
#include <halftone/link/shared_link.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

using namespace halftone;
using protocol::Opcode;

TEST_CASE("what a person has made of the screen is read as it is shown") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  const auto picture = test::noise(512, 512, 9);
  driver.begin(512, 512);
  for (int y = 0; y < 512; ++y) driver.send_row(y, picture.row(y));
  driver.finish();
  CHECK(driver.read_shown() == picture.rgb);
  link->send(test::bytes_of({{Opcode::zoom, 1, {3}, {}}}));
  const std::vector<std::uint8_t> shown = driver.read_shown();
  REQUIRE(shown.size() == picture.rgb.size());
  CHECK(std::equal(shown.begin(), shown.begin() + 3, picture.rgb.begin()));
  CHECK(std::equal(shown.begin() + 21, shown.begin() + 24, picture.rgb.begin()));
  CHECK(std::equal(shown.begin() + 24, shown.begin() + 27, picture.rgb.begin() + 3));
  CHECK_THROWS_AS(driver.read_screen(), link::DeviceError);
}

namespace {

/// Over another link, after each of whose messages somebody else has something to say.
struct Interrupted final : link::Link {
  void send(std::span<const std::uint8_t> bytes) override {
    over->send(bytes);
    over->send(test::bytes_of({{Opcode::pan, ++spoken, {spoken % 512, 0}, {}}}));
  }
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    return over->receive(bytes, timeout);
  }

  std::unique_ptr<link::Link> over = link::open("mem:");
  std::uint32_t spoken = 0;
};

} // namespace

TEST_CASE("somebody may speak after each message of a driver that begins") {
  Interrupted link;
  driver::Driver driver(link);
  for (int round = 0; round < 3; ++round) CHECK_NOTHROW(driver.begin(300, 200));
  CHECK(link.spoken > 0);
}

TEST_CASE("a second thread may speak while a driver sends, verifies and reads") {
  link::SharedLink link(link::open("mem:"));
  driver::Driver driver(link);
  const auto picture = test::noise(300, 200, 8);
  driver.begin(300, 200);
  {
    const std::jthread other([&](const std::stop_token& stop) {
      for (std::uint32_t i = 0; !stop.stop_requested(); ++i)
        link.send(test::bytes_of({{Opcode::pan, i, {i % 512, 0}, {}}, {Opcode::zoom, i, {i % 4}, {}}}));
    });
    for (int round = 0; round < 3; ++round) {
      for (int y = 0; y < 200; ++y) driver.send_row(y, picture.row(y));
      driver.finish();
      CHECK(driver.read_picture() == picture.rgb);
    }
  }
}
