#include <halftone/watch/panel.h>

#include <halftone/device/port.h>
#include <halftone/device/screen.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace halftone;
namespace display = halftone::display;
using watch::commands_for;

namespace {

/// What the event makes of a device, which must take all its commands.
device::Device after(const display::Event& event, const device::Device& before) {
  device::Port port;
  port.device = before;
  device::Bytes replies;
  port.receive(commands_for(event, before.registers), replies);
  port.end(replies);
  CHECK(port.device.registers.errors == before.registers.errors);
  CHECK(replies.empty());
  return port.device;
}

device::Device noise() {
  device::Device device;
  std::mt19937 random(508);
  for (device::Bytes& image : device.images)
    std::ranges::generate(image, [&] { return static_cast<std::uint8_t>(random()); });
  return device;
}

device::Pixel pixel_at(const device::Device& device, int x, int y) {
  const device::Bytes screen = device::screen(device);
  const auto offset = static_cast<std::size_t>(3 * (512 * y + x));
  return {screen[offset], screen[offset + 1], screen[offset + 2]};
}

} // namespace

TEST_CASE("panning moves the image, around its edges too") {
  device::Device device = noise();
  device = after(display::Pan{-3, 5}, device);
  CHECK(device.registers.pan_x == 509);
  CHECK(device.registers.pan_y == 5);
  device = after(display::Pan{16, -16}, device);
  CHECK(device.registers.pan_x == 13);
  CHECK(device.registers.pan_y == 501);
}

TEST_CASE("zooming keeps what lies under the mouse where it is") {
  for (const auto& [x, y] : {std::pair{100, 200}, std::pair{0, 0}, std::pair{511, 511}, std::pair{256, 3}}) {
    device::Device device = noise();
    device.registers.pan_x = 500;
    const device::Pixel there = pixel_at(device, x, y);
    for (const int zoom : {1, 2, 3, 3, 2, 1, 0, 0}) {
      const int steps = zoom > device.registers.zoom   ? 1
                        : zoom < device.registers.zoom ? -1
                        : zoom == 3                    ? 1
                                                       : -1;
      device = after(display::Zoom{steps, x, y}, device);
      CAPTURE(x, y, zoom);
      CHECK(device.registers.zoom == zoom);
      CHECK(pixel_at(device, x, y) == there);
    }
  }
}

TEST_CASE("the look-up tables are what they are called") {
  device::Device device = noise();
  device = after(display::SetTables{display::Tables::negative}, device);
  CHECK(device.luts[1][0] == 255);
  CHECK(device.luts[2][100] == 155);
  device = after(display::SetTables{display::Tables::contours}, device);
  CHECK(device.luts[0][31] == 0);
  CHECK(device.luts[0][32] == 36);
  CHECK(device.luts[0][255] == 255);
  device = after(display::SetTables{display::Tables::false_color}, device);
  CHECK(device.luts[2][40] > device.luts[0][40]); // cold below
  CHECK(device.luts[0][250] > device.luts[2][250]);
  device = after(display::SetTables{display::Tables::linear}, device);
  CHECK(device.luts == device::Device().luts);
}

TEST_CASE("buffer and overlay change what is shown and nothing else") {
  const device::Device before = noise();
  device::Device device = after(display::OtherBuffer{}, before);
  CHECK(device.registers.shown == 1);
  CHECK(device.registers.written == 0);
  device = after(display::ToggleOverlay{}, device);
  CHECK(device.registers.overlay.on);
  device = after(display::ToggleOverlay{}, after(display::OtherBuffer{}, device));
  device.registers.commands = before.registers.commands;
  CHECK(device.registers == before.registers);
}

TEST_CASE("going home undoes pan and zoom") {
  device::Device device = noise();
  device = after(display::Home{}, after(display::Zoom{2, 7, 9}, after(display::Pan{40, 50}, device)));
  CHECK(device.registers.zoom == 0);
  CHECK(device.registers.pan_x == 0);
  CHECK(device.registers.pan_y == 0);
}

TEST_CASE("what is no matter of the device is no command") {
  const device::Registers registers;
  for (const display::Event& event : {display::Event(display::Pause{}), display::Event(display::Probe{1, 2}),
                                      display::Event(display::Quit{}), display::Event(display::Zoom{-1})})
    CHECK(commands_for(event, registers).empty());
}
