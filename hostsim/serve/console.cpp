#include <halftone/serve/console.h>

#include <halftone/link/link.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

namespace halftone::serve {

Console::Console() : descriptor_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (!descriptor_) throw link::DeviceError(std::string("no console: ") + std::strerror(errno));
}

void Console::send(std::span<const std::uint8_t> commands) {
  const std::lock_guard lock(mutex_);
  commands_.insert(commands_.end(), commands.begin(), commands.end());
  ::eventfd_write(descriptor_.number(), 1);
}

std::vector<std::uint8_t> Console::take() {
  const std::lock_guard lock(mutex_);
  eventfd_t count = 0;
  ::eventfd_read(descriptor_.number(), &count);
  return std::exchange(commands_, {});
}

bool Console::is_waiting() {
  const std::lock_guard lock(mutex_);
  return !commands_.empty();
}

} // namespace halftone::serve
