#pragma once
// Where a replay stops, as its user says it.

#include <halftone/device/device.h>
#include <halftone/recording/walk.h>

#include <cstdint>
#include <string>
#include <variant>

namespace halftone::m508 {

struct AfterCommand {
  std::uint64_t number = 0; ///< 0: before the first
};
struct AtMark {
  std::string name;
};
struct AtFrame {
  std::uint64_t number = 0; ///< fields of 1/60 s that have begun since power-on
};
using Stop = std::variant<AfterCommand, AtMark, AtFrame>;

/// "120", "mark:NAME" or "frame:N". Throws ArgumentError.
Stop parse_stop(const std::string& text);

/// Whether the device, which has executed this step, is where it is to stop.
bool is_reached(const Stop& stop, const recording::Step& step, const device::Device& device);

/// Whether it is so before the first step.
bool is_reached(const Stop& stop, const device::Device& device);

} // namespace halftone::m508
