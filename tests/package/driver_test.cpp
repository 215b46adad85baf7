// A driver's own test in C++: what the driver sends goes into a device in this process, and the test looks at
// what that does to memory and screen.

#include <halftone/device/port.h>
#include <halftone/device/screen.h>
#include <halftone/protocol/message.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace halftone;

namespace {

/// The driver that is tested: it draws a red square.
std::vector<std::uint8_t> draw_square(std::uint32_t x, std::uint32_t y, std::uint32_t size) {
  std::vector<std::uint8_t> stream;
  append(stream, protocol::Message{protocol::Opcode::fill, 1, {x, y, size, size, 255, 0, 0}, {}});
  return stream;
}

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::exit(1);
}

} // namespace

int main() {
  device::Port port;
  std::vector<std::uint8_t> replies;
  port.receive(draw_square(100, 50, 8), replies);

  const auto shown = device::screen(port.device);
  const auto red = [&](std::size_t x, std::size_t y) { return shown[(y * 512 + x) * 3]; };
  require(port.device.registers.error == protocol::Fault::none, "the device understood every command");
  require(red(100, 50) == 255 && red(107, 57) == 255, "the square is filled");
  require(red(99, 50) == 0 && red(108, 57) == 0, "nothing beside it is touched");

  port.receive(draw_square(510, 50, 8), replies);
  require(port.device.registers.error == protocol::Fault::out_of_limits, "a square over the edge is refused");
  return 0;
}
