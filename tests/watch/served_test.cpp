// A server in one thread, a client in another, and whoever looks and presses keys in a third: what m508 serve
// does with a window, without a window.

#include "fake_display.h"
#include "support/messages.h"
#include "support/scratch.h"

#include <halftone/bus/buses.h>
#include <halftone/device/screen.h>
#include <halftone/file/descriptor.h>
#include <halftone/link/link.h>
#include <halftone/recording/write.h>
#include <halftone/serve/console.h>
#include <halftone/serve/server.h>
#include <halftone/watch/watcher.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include <sys/eventfd.h>

using namespace halftone;
using namespace std::chrono_literals;
using protocol::Opcode;

TEST_CASE("a device is watched and operated while a client draws on it") {
  const test::Scratch scratch;
  const serve::Listener listener(link::UnixAddress{scratch / "s"});
  device::Device device;
  watch::Tape tape;
  recording::Writer recording([&](std::span<const std::uint8_t> bytes) { tape.append(bytes); }, device);
  serve::Console console;
  const file::Descriptor end(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  std::jthread server([&] { serve::serve(listener, device, {}, &recording, end, &console); });
  std::atomic<bool> is_enough = false;
  std::atomic<unsigned> drawn = 0;
  std::jthread client([&] {
    const auto link = link::open(listener.address(), 10s);
    for (; !is_enough; ++drawn) {
      link->send(test::bytes_of({{Opcode::fill, drawn, {0, drawn % 512, 512, 1, drawn % 256, 1, 2}, {}}}));
      std::this_thread::sleep_for(1ms);
    }
    link->finish();
  });

  test::FakeDisplay::Log log;
  watch::Displays displays;
  displays.push_back(std::make_unique<test::FakeDisplay>(log));
  watch::Player player({}, recording::Trail::grows);
  const std::vector<device::Bus> buses = bus::built_in();
  watch::Watcher watcher(
      displays, player, tape, buses,
      {[] { return "a device"; }, [&](const device::Bytes& commands) { console.send(commands); }});
  const auto patience = std::chrono::steady_clock::now() + 30s;
  constexpr unsigned keys = 40;
  for (unsigned i = 0; i < keys; ++i) {
    log.events = {display::Pan{1, 0}};
    REQUIRE(watcher.look());
  }
  is_enough = true;
  client.join();
  while (std::chrono::steady_clock::now() < patience && player.length() < drawn + keys) watcher.look();
  for (int i = 0; i < 4; ++i) watcher.look();
  ::eventfd_write(end.number(), 1);
  server.join();
  CHECK(player.length() == drawn + keys);
  CHECK(device.registers.pan_x != 0);
  CHECK(log.screen == device::screen(device));
}
