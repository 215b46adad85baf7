#pragma once
// What a recording is made of.

#include <halftone/device/clock.h>
#include <halftone/recording/trace.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace halftone::m508 {

struct Share {
  std::uint64_t count = 0;
  std::uint64_t bytes = 0;
};

struct Tally {
  std::uint64_t commands = 0; ///< with the rejected ones, and restarts of the device, which have no name
  std::uint64_t rejected = 0;
  std::uint64_t sessions = 0; ///< up to that of the last command
  std::uint64_t bytes = 0;    ///< of all data
  std::uint64_t fill = 0;     ///< zeros between commands
  std::uint64_t pixels = 0;   ///< addressed by all commands
  bool cut_off = false;       ///< the last record is not whole
  std::map<std::string, Share> opcodes;
  std::map<std::string, Share> errors;
  std::vector<device::Clock> clocks; ///< one for each bus: the time from the first command to the last
};

Tally tally_of(const recording::Trace& trace, const std::vector<device::Bus>& buses);

} // namespace halftone::m508
