#include <halftone/device/device.h>

#include <catch2/catch.hpp>

using namespace halftone;
using protocol::Message;
using protocol::Opcode;

TEST_CASE("at the end of its numbers the clock stands still, and nothing brings it back") {
  constexpr std::uint64_t end = ~std::uint64_t{0};
  constexpr std::uint32_t last_field = 1'106'804'644; // 2^64 ps, 60 of them a second
  const protocol::Item fill{0, 24, Message{Opcode::fill, 1, {0, 0, 512, 512, 1, 2, 3}, {}}};
  const protocol::Item wait{0, 15, Message{Opcode::wait, 2, {65'535}, {}}};
  const protocol::Item damage{0, 1'000, protocol::Rejection{protocol::Fault::damaged, 0, 0}};
  for (const device::Bus& bus : {device::Bus{"unlimited", 0, 0}, device::Bus{"slow", 520'833'333, 1'000},
                                 device::Bus{"a byte is an age", end, 0}, device::Bus{"a frame", 0, end}}) {
    for (const std::uint64_t before :
         {std::uint64_t{0}, std::uint64_t{10'000}, std::uint64_t{20'000'000'000}}) {
      device::Device device;
      device.clock.bus = bus;
      device.clock.picoseconds = end - before;
      CHECK(device::fields(device.clock) >= last_field - 1);
      for (const protocol::Item& item : {fill, damage, wait, fill, wait, damage}) {
        const device::Clock earlier = device.clock;
        device.execute(item);
        INFO(bus.name << ", " << before << " ps before the end");
        CHECK(device.clock.picoseconds >= earlier.picoseconds);
        CHECK(device::fields(device.clock) >= device::fields(earlier));
      }
      CHECK(device.clock.picoseconds == end);
      CHECK(device::fields(device.clock) == last_field);
    }
  }
  device::Clock clock{{}, end - 30'000'000'000};
  const std::uint32_t field = device::fields(clock);
  clock.wait(1); // there is room for one more
  CHECK(device::fields(clock) == field + 1);
  CHECK(clock.picoseconds < end);
}

TEST_CASE("a transfer that takes longer than the clock can count ends at its end") {
  device::Clock clock{{"a byte takes 53 days", std::uint64_t{1} << 62, 0}};
  clock.transfer(3);
  CHECK(clock.picoseconds == 3ULL << 62);
  clock.picoseconds = 0;
  clock.transfer(24); // 6 * 2^64 ps
  CHECK(clock.picoseconds == ~std::uint64_t{0});
}
