#include <halftone/device/port.h>

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <iostream>

using namespace halftone;

// Hidden: it measures, and means something in a release build on a quiet machine only.
TEST_CASE("raw pixels are taken in at half the speed of their checksum and a copy, or faster", "[.][speed]") {
  std::vector<std::uint8_t> stream;
  const std::vector<std::uint8_t> pixels(std::size_t{1365} * 3, 0x5A); // as many as a command can carry
  for (std::uint32_t command = 0; stream.size() < device::image_size; ++command)
    append(stream, protocol::Message{protocol::Opcode::pixels, command, {}, pixels});

  const auto best_of = [](const auto& task) {
    double best = 1e9;
    for (int run = 0; run < 100; ++run) {
      const auto start = std::chrono::steady_clock::now();
      task();
      best = std::min(
          best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
  };
  std::uint32_t sum = 0;
  std::vector<std::uint8_t> copy(stream.size());
  const double floor = best_of([&] {
    sum += protocol::checksum(stream); // zlib's
    std::memcpy(copy.data(), stream.data(), stream.size());
  });
  device::Port port;
  std::vector<std::uint8_t> replies;
  const double taken = best_of([&] { port.receive(stream, replies); });
  std::cout << stream.size() << " bytes: checksum and copy " << floor << " ms, decoded and written " << taken
            << " ms (" << sum << ")\n";
  CHECK(port.device.registers.errors == 0);
  CHECK(taken < 2 * floor);
}
