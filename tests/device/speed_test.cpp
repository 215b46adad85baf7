#include "support/speed.h"

#include <halftone/device/port.h>

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <limits>

using namespace halftone;

// Hidden from builds where it means nothing: see halftone_speed_test in tests/CMakeLists.txt.
TEST_CASE("raw pixels are taken in at half the speed of their checksum and a copy, or faster", "[.][speed]") {
  std::vector<std::uint8_t> stream;
  const std::vector<std::uint8_t> pixels(std::size_t{1365} * 3, 0x5A); // as many as a command can carry
  for (std::uint32_t command = 0; stream.size() < device::image_size; ++command)
    append(stream, protocol::Message{protocol::Opcode::pixels, command, {}, pixels});

  std::uint32_t sum = 0;
  std::vector<std::uint8_t> copy(stream.size());
  device::Port port;
  std::vector<std::uint8_t> replies;
  double floor = std::numeric_limits<double>::infinity(), taken = floor;
  for (int round = 0; round < test::most_rounds && !(taken < 2 * floor); ++round) {
    floor = std::min(floor, test::best_of(50, [&] {
                       sum += protocol::checksum(stream); // zlib's
                       std::memcpy(copy.data(), stream.data(), stream.size());
                     }));
    taken = std::min(taken, test::best_of(50, [&] { port.receive(stream, replies); }));
  }
  std::cout << stream.size() << " bytes: checksum and copy " << floor << " ms, decoded and written " << taken
            << " ms (" << sum << ")\n";
  CHECK(port.device.registers.errors == 0);
  CHECK(taken < 2 * floor);
}
