#include "observed.h"
#include "streams.h"

#include <halftone/inspect/memory.h>
#include <halftone/inspect/reference.h>
#include <halftone/inspect/who.h>

#include <catch2/catch.hpp>

using namespace halftone;
using test::Random;

TEST_CASE("addressed names the pixels that a command is seen to write, and no other") {
  std::size_t writes = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    const recording::Trace trace = test::trace_of(test::random_stream(random));
    recording::Walk walk(trace);
    while (const auto step = walk.next()) {
      const protocol::Message* message = inspect::message_of(*step);
      if (message == nullptr) continue;
      device::Device device = walk.device();
      device.registers.write_mask = {0xFF, 0xFF, 0xFF}; // with all bits written, every write is seen
      const auto regions = device::addressed(device.registers, *message);
      if (regions.empty() && random() % 8 != 0) continue;
      const test::Written written = test::execute_and_watch(device, step->item);
      ++writes;
      INFO("seed " << seed << ", command " << step->number);
      // A copy of a rectangle onto itself cannot be seen.
      const bool is_copy = message->opcode == protocol::Opcode::copy;
      for (std::size_t plane = 0; plane < 3; ++plane) {
        test::Written::value_type named(written[plane].size());
        for (const device::Region& region : regions) {
          if (static_cast<std::size_t>(region.plane) != plane) continue;
          for (std::size_t y = region.area.y; y < std::size_t{region.area.y} + region.area.height; ++y)
            for (std::size_t x = region.area.x; x < std::size_t{region.area.x} + region.area.width; ++x)
              named[y * 512 + x] = true;
        }
        if (!is_copy) REQUIRE((named == written[plane]));
        for (std::size_t i = 0; is_copy && i < named.size(); ++i)
          if (written[plane][i] && !named[i]) FAIL("pixel " << i << " of plane " << plane);
      }
    }
  }
  CHECK(writes > 100);
}

TEST_CASE("a copy addresses all of its rectangle in the other place, in noise where every pixel shows it") {
  std::size_t seen = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    device::Device device;
    for (device::Bytes& image : device.images)
      for (std::uint8_t& byte : image) byte = static_cast<std::uint8_t>(random());
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    const std::uint32_t width = 1 + below(60), height = 1 + below(60);
    const std::uint32_t right = 512 - width, bottom = 512 - height;
    const protocol::Message copy{protocol::Opcode::copy,
                                 1,
                                 {below(right), below(bottom), width, height,
                                  seed % 4 == 0 ? right : below(right),
                                  seed % 4 == 1 ? bottom : below(bottom), below(2)},
                                 {}};
    const auto regions = device::addressed(device.registers, copy);
    REQUIRE(regions.size() == 1);
    const device::Device before = device;
    device.execute({0, 28, copy});
    INFO("seed " << seed);
    for (std::uint16_t y = 0; y < 512; ++y) {
      for (std::uint16_t x = 0; x < 512; ++x) {
        const inspect::Place place{device::Plane::image_0, x, y};
        const bool changed = inspect::value_at(before, place) != inspect::value_at(device, place);
        const bool named = inspect::holds(regions[0].area, x, y);
        if (changed && !named) FAIL("pixel (" << x << ", " << y << ") is written, and not named");
        seen += changed ? 1 : 0;
        // Noise is the same in two places for one pixel in 2^24.
        if (named && !changed && copy.operands[6] == 1)
          FAIL("pixel (" << x << ", " << y << ") is named, and not written");
      }
    }
  }
  CHECK(seen > 10'000);
}

TEST_CASE("who finds a copy at the right and lower edge of where it went, and not beyond") {
  const recording::Trace trace =
      test::trace_of_text("copy x=0 y=0 width=30 height=20 to_x=100 to_y=200 from=1\n"
                          "copy x=0 y=0 width=30 height=20 to_x=482 to_y=492 from=1\n");
  const auto writer = [&](std::uint16_t x, std::uint16_t y) {
    const auto last = inspect::who(trace, {device::Plane::image_0, x, y}, 1).last;
    return last ? last->command.number : 0;
  };
  CHECK(writer(100, 200) == 1);
  CHECK(writer(129, 219) == 1);
  CHECK(writer(130, 219) == 0);
  CHECK(writer(129, 220) == 0);
  CHECK(writer(99, 200) == 0);
  CHECK(writer(100, 199) == 0);
  CHECK(writer(511, 511) == 2);
  CHECK(writer(481, 511) == 0);
}
