#include "waiting.h"

#include <halftone/link/link.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include <poll.h>

namespace halftone::link {

short wait_for(const file::Descriptor& descriptor, short events,
               std::chrono::steady_clock::time_point deadline) {
  using std::chrono::milliseconds;
  constexpr milliseconds longest = std::chrono::hours(1); // poll takes an int
  while (true) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd entry{descriptor.number(), events, 0};
    const int ready = ::poll(&entry, 1, static_cast<int>(std::clamp(left, milliseconds(0), longest).count()));
    if (ready > 0) return entry.revents;
    if (ready < 0 && errno != EINTR)
      throw DeviceError(std::string("waiting for the device: ") + std::strerror(errno));
    if (ready == 0 && left <= longest) return 0;
  }
}

} // namespace halftone::link
