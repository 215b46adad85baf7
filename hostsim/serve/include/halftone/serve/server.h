#pragma once
// The device as a process: clients in turn, on one device.

#include <halftone/serve/console.h>
#include <halftone/serve/listener.h>
#include <halftone/serve/session.h>

#include <halftone/device/device.h>
#include <halftone/file/descriptor.h>
#include <halftone/recording/write.h>

#include <chrono>
#include <cstdint>
#include <optional>

namespace halftone::serve {

struct Settings {
  bool once = false;                       ///< ends after the first client that sent anything
  std::optional<std::uint64_t> fault_seed; ///< client n, from 0 on, has the faults of this seed + n
  /// A client whose replies wait and that takes no byte of them for so long is cut off: whether it has gone,
  /// or has ended its side and still means to read, cannot be told from here.
  std::chrono::milliseconds patience = std::chrono::seconds(30);
};

/// Serves one client after the other, while others wait in the order in which they came, until `stop` is
/// readable, which is looked at after each 4 kB of commands at the latest. What a client leaves behind stays
/// for the next. What the console says is done between two commands of a client. The recording may be null,
/// and so may the console. Throws link::DeviceError, and what the recording's sink does.
void serve(const Listener& listener, device::Device& device, const Settings& settings,
           recording::Writer* recording, const file::Descriptor& stop, Console* console = nullptr);

} // namespace halftone::serve
