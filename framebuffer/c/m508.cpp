#include <halftone/c/m508.h>

#include <halftone/device/port.h>
#include <halftone/device/screen.h>
#include <halftone/device/snapshot.h>

#include <algorithm>
#include <array>
#include <new>
#include <span>

using namespace halftone;

struct m508 {
  device::Port port;
  device::Bytes replies;
  std::size_t taken = 0; ///< bytes of the replies that the caller has
};

namespace {

/// Exceptions must not reach C: the only one possible is a lack of memory.
template<typename Work>
int without_exceptions(Work work) {
  try {
    work();
    return 0;
  } catch (const std::bad_alloc&) {
    return -1;
  }
}

} // namespace

m508* m508_create() {
  m508* device = nullptr;
  without_exceptions([&] { device = new m508; });
  return device;
}

void m508_destroy(m508* device) { delete device; }

int m508_send(m508* device, const uint8_t* bytes, size_t size) {
  return without_exceptions([&] { device->port.receive({bytes, size}, device->replies); });
}

int m508_end(m508* device) {
  return without_exceptions([&] { device->port.end(device->replies); });
}

size_t m508_receive(m508* device, uint8_t* bytes, size_t size) {
  const std::size_t count = std::min(size, device->replies.size() - device->taken);
  std::ranges::copy(std::span(device->replies).subspan(device->taken, count), bytes);
  device->taken += count;
  if (device->taken == device->replies.size()) {
    device->replies.clear();
    device->taken = 0;
  }
  return count;
}

void m508_pixel(const m508* device, int buffer, int x, int y, uint8_t rgb[3]) {
  const auto offset = (static_cast<std::size_t>(y) * M508_WIDTH + static_cast<std::size_t>(x)) * 3;
  const device::Bytes& image = device->port.device.images[static_cast<std::size_t>(buffer)];
  std::ranges::copy(std::span(image).subspan(offset, 3), rgb);
}

void m508_shown(const m508* device, int x, int y, uint8_t rgb[3]) {
  std::array<std::uint8_t, std::size_t{M508_WIDTH} * 3> row;
  device::scan_out(device->port.device, static_cast<std::uint32_t>(y), row);
  std::ranges::copy(std::span(row).subspan(static_cast<std::size_t>(x) * 3, 3), rgb);
}

void m508_screen(const m508* device, uint8_t* rgb) {
  constexpr std::size_t row = std::size_t{M508_WIDTH} * 3;
  for (std::uint32_t y = 0; y < M508_HEIGHT; ++y)
    device::scan_out(device->port.device, y, {rgb + y * row, row});
}

m508_errors m508_errors_of(const m508* device) {
  const device::Registers& r = device->port.device.registers;
  return {static_cast<int>(r.error), r.error_sequence, r.errors};
}

uint32_t m508_commands(const m508* device) { return device->port.device.registers.commands; }

uint32_t m508_state_checksum(const m508* device) { return device::state_checksum(device->port.device); }
