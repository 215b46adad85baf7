#pragma once
// The device and its recordings on displays.

#include <halftone/device/device.h>
#include <halftone/recording/trace.h>
#include <halftone/recording/write.h>
#include <halftone/serve/server.h>
#include <halftone/serve/stop_signals.h>
#include <halftone/watch/player.h>
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
enum class Start {
  at_end,   ///< on the way there, as fast as it can be played
  at_pace,  ///< at its beginning, and played at the pace of its bus
  elsewhere ///< at its beginning, until stand_at() tells where
};

/// A recording on displays.
class ShownRecording {
public:
  /// The player has the recording; it and the displays must outlive this.
  ShownRecording(const std::string& title, watch::Player& player, Start start,
                 const watch::Displays& displays);

  /// As Watcher::look; waits for nothing where there is other work to do.
  bool look(bool is_busy);

  /// After so many commands, once the player has come so far and where nobody has gone elsewhere meanwhile:
  /// at once or, where it is played at a pace, when what is seen comes there.
  void stand_at(std::uint64_t commands) { place_ = commands; }

  /// What is played comes no further yet.
  void hold_at(std::uint64_t commands) { player_.hold_at(commands); }

private:
  void come_to_place();

  watch::Player& player_;
  Start start_;
  std::vector<device::Bus> buses_;
  watch::Tape nothing_more_;
  watch::Watcher watcher_;
  std::optional<std::uint64_t> place_; ///< to stand at, some time
};

} // namespace halftone::m508
