#pragma once
// A display without anything to see.

#include <halftone/device/device.h>
#include <halftone/display/display.h>

#include <utility>
#include <vector>

namespace halftone::test {

/// What it is shown, and what somebody does at it, in a log that outlives it.
struct FakeDisplay final : display::Display {
  struct Log {
    device::Bytes screen;
    std::vector<display::Rows> changes;
    display::Words words;
    std::vector<display::Event> events; ///< taken at the next look
  };
  explicit FakeDisplay(Log& kept) : log(kept) {}

  bool is_operated() const override { return true; }
  void show(const display::Frame& frame) override {
    log.screen.assign(frame.rgb.begin(), frame.rgb.end());
    log.changes.push_back(frame.changed);
  }
  void say(const display::Words& words) override { log.words = words; }
  std::vector<display::Event> poll() override { return std::exchange(log.events, {}); }

  Log& log;
};

} // namespace halftone::test
