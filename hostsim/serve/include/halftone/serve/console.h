#pragma once
// Commands for the device from beside its clients: a person at its front panel.

#include <halftone/file/descriptor.h>

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace halftone::serve {

/// Both sides may be in any thread. Throws link::DeviceError where the system has no descriptor left.
class Console {
public:
  Console();

  /// Whole commands, none of them a query: nobody would hear the reply.
  void send(std::span<const std::uint8_t> commands);

  /// What was sent since the last time.
  std::vector<std::uint8_t> take();

  bool is_waiting();

  /// Readable while there is something to take.
  const file::Descriptor& descriptor() const { return descriptor_; }

private:
  std::mutex mutex_;
  std::vector<std::uint8_t> commands_;
  file::Descriptor descriptor_;
};

} // namespace halftone::serve
