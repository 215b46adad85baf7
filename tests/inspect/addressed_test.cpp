#include "observed.h"
#include "streams.h"

#include <halftone/inspect/memory.h>
#include <halftone/inspect/reference.h>

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
