#include <halftone/device/snapshot.h>

#include <catch2/catch.hpp>

using namespace halftone;
using device::Device;
using device::Registers;

namespace {

bool is_restored(const Registers& registers) {
  Device device;
  device.registers = registers;
  return device::restore(device::save(device)).has_value();
}

/// Whether a register with a range takes its largest value, and not one more.
template<typename Value>
bool ends_at(Value Registers::*member, Value most) {
  Registers last, beyond;
  last.*member = most;
  beyond.*member = static_cast<Value>(static_cast<unsigned>(most) + 1);
  return is_restored(last) && !is_restored(beyond);
}

} // namespace

TEST_CASE("a snapshot's registers have the ranges that commands can give them") {
  CHECK(ends_at<std::uint8_t>(&Registers::written, 1));
  CHECK(ends_at<std::uint8_t>(&Registers::shown, 1));
  CHECK(ends_at<std::uint8_t>(&Registers::zoom, 3));
  CHECK(ends_at<std::uint16_t>(&Registers::pan_x, 511));
  CHECK(ends_at<std::uint16_t>(&Registers::pan_y, 511));
  CHECK(ends_at<std::uint16_t>(&Registers::cursor_x, 511));
  CHECK(ends_at<std::uint16_t>(&Registers::cursor_y, 511));
  CHECK(ends_at<std::uint16_t>(&Registers::x, 511));
  CHECK(ends_at<std::uint16_t>(&Registers::y, 511));
  CHECK(ends_at(&Registers::error, protocol::fault_table.back().fault));
}

TEST_CASE("a snapshot's window is on the screen, and the writing position in the window") {
  const auto restored = [](const device::Rectangle& window, std::uint16_t x, std::uint16_t y) {
    Registers registers;
    registers.window = window;
    registers.x = x;
    registers.y = y;
    return is_restored(registers);
  };
  CHECK(restored({10, 20, 502, 492}, 10, 20));
  CHECK(restored({10, 20, 502, 492}, 511, 511));
  CHECK_FALSE(restored({10, 20, 503, 492}, 10, 20));
  CHECK_FALSE(restored({10, 20, 502, 493}, 10, 20));
  CHECK_FALSE(restored({10, 20, 0, 1}, 10, 20));
  CHECK_FALSE(restored({10, 20, 1, 0}, 10, 20));
  CHECK(restored({10, 20, 3, 4}, 12, 23));
  CHECK_FALSE(restored({10, 20, 3, 4}, 13, 23));
  CHECK_FALSE(restored({10, 20, 3, 4}, 12, 24));
  CHECK_FALSE(restored({10, 20, 3, 4}, 9, 20));
  CHECK_FALSE(restored({10, 20, 3, 4}, 10, 19));
}
