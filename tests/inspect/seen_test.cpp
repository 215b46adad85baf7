#include "streams.h"

#include <halftone/inspect/seen.h>
#include <halftone/inspect/who.h>

#include <halftone/device/screen.h>

#include <catch2/catch.hpp>

#include <set>

using namespace halftone;

TEST_CASE("what is said to be seen is what the device shows, at every pixel") {
  std::set<inspect::Decider> deciders;
  for (std::uint64_t seed = 200; seed < 260; ++seed) {
    test::Random random(seed);
    device::Device device = inspect::device_after(test::trace_of(test::random_stream(random)));
    for (std::uint8_t& byte : device.overlay) byte = static_cast<std::uint8_t>(random() & random());
    for (std::uint8_t& byte : device.cursor_pattern) byte = static_cast<std::uint8_t>(random());
    device.registers.blank = device.registers.blank && random() % 4 == 0;
    const device::Bytes screen = device::screen(device);
    for (std::uint16_t y = 0; y < 512; ++y) {
      for (std::uint16_t x = 0; x < 512; ++x) {
        const inspect::Seen seen = inspect::seen_at(device, x, y);
        deciders.insert(seen.decider);
        const std::size_t i = (std::size_t{y} * 512 + x) * 3;
        if (seen.color != device::Pixel{screen[i], screen[i + 1], screen[i + 2]})
          FAIL("seed " << seed << ", pixel (" << x << ", " << y << ")");
      }
    }
  }
  CHECK(deciders.size() == 5);
}
