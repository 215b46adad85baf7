// On any stream the device does what the naive device does: replies, memory, screen and clock; and its state
// survives a snapshot.

#include "stream.h"

#include "../device/naive_device.h"

#include <halftone/device/device.h>
#include <halftone/device/screen.h>
#include <halftone/device/snapshot.h>

#include <array>
#include <cstdlib>

using namespace halftone;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

/// Of screen and overlay a few rows: a naive row takes as long as the rest. What is shown depends on the
/// clock.
void require_same_memory(const device::Device& fast, const test::NaiveDevice& naive,
                         std::span<const std::uint8_t> rows, bool has_clock) {
  require(naive.holds(0, fast.images[0]) && naive.holds(1, fast.images[1]) &&
          naive.holds_overlay(fast.overlay));
  std::array<std::uint8_t, std::size_t{512} * 3> row;
  for (const std::uint32_t half : rows) {
    const std::uint32_t y = half * 2;
    device::scan_out(fast, y, row);
    for (std::uint32_t x = 0; x < 512; ++x) {
      if (has_clock)
        require((test::NaiveDevice::Pixel{row[x * 3], row[x * 3 + 1], row[x * 3 + 2]} == naive.shown(x, y)));
      require((fast.overlay[y * 64 + x / 8] >> (7 - x % 8) & 1) == (naive.overlay_bit(x, y) ? 1 : 0));
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider fuzz(bytes, size);
  const auto byte_picoseconds = fuzz.ConsumeIntegralInRange<std::uint64_t>(0, 600'000'000);
  const auto rows = fuzz.ConsumeBytes<std::uint8_t>(4);
  const bool is_saved = fuzz.ConsumeIntegralInRange(0, 9) == 0;
  const fuzz::Bytes stream = fuzz::make_stream(fuzz);

  device::Device fast;
  fast.clock.bus = {"fuzzed", byte_picoseconds, 0};
  test::NaiveDevice naive(byte_picoseconds);
  protocol::Decoder decoder(protocol::Direction::to_device);
  const auto both_execute = [&](const protocol::Item& item) {
    fuzz::Bytes replies;
    fast.execute(item, replies);
    require(replies == naive.execute(item));
  };
  std::span<const std::uint8_t> rest = stream;
  while (const auto item = decoder.next(rest)) both_execute(*item);
  while (const auto item = decoder.drain()) both_execute(*item);
  // The naive clock counts sixtieths in 64 bits; a stream of many long waits goes beyond.
  const bool has_clock = naive.picoseconds() < 300'000'000'000'000'000;
  if (has_clock) {
    both_execute({0, 0, protocol::Message{protocol::Opcode::status, 0, {}, {}}});
    require(fast.clock.picoseconds == naive.picoseconds());
  }
  require_same_memory(fast, naive, rows, has_clock);

  if (!is_saved) return 0;
  auto restored = device::restore(device::save(fast));
  require(restored.has_value());
  restored->clock.bus = fast.clock.bus;
  require(*restored == fast);
  return 0;
}
