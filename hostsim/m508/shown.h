#pragma once
// The device and its recordings on displays.

#include <halftone/device/device.h>
#include <halftone/recording/trace.h>
#include <halftone/recording/write.h>
#include <halftone/serve/server.h>
#include <halftone/serve/stop_signals.h>
#include <halftone/watch/tape.h>
#include <halftone/watch/watcher.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halftone::m508 {

/// serve::serve, beside displays that show what the device does, until a signal comes, the server is
/// done, or somebody at a display has had enough. `recording` writes to the tape. Throws what serve throws,
/// and DisplayError.
void serve_shown(const serve::Listener& listener, device::Device& device, const serve::Settings& settings,
                 recording::Writer& recording, const serve::StopSignals& stop,
                 const watch::Displays& displays, watch::Tape& tape);

/// Where a recording is when it is first seen.
struct Start {
  bool at_pace = false;               ///< at its beginning, and played at the pace of its bus
  std::optional<std::uint64_t> after; ///< so many commands; at its end where there is neither
};

/// Shows a recording until a signal comes or somebody at a display has had enough.
void show_recording(const std::string& title, const recording::Trace& trace, const Start& start,
                    const serve::StopSignals& stop, const watch::Displays& displays);

} // namespace halftone::m508
