#include "picture.h"
#include "support/messages.h"

#include <halftone/driver/driver.h>
#include <halftone/link/shared_link.h>

#include <catch2/catch.hpp>

#include <thread>

using namespace halftone;
using protocol::Opcode;

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
