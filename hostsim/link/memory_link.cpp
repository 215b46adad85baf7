#include "memory_link.h"

#include <halftone/device/port.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace halftone::link {

namespace {

class MemoryLink final : public Link {
public:
  void send(std::span<const std::uint8_t> bytes) override { port_.receive(bytes, replies_); }

  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds) override {
    // What has not been answered by now never will be: there is nothing to wait for.
    if (received_ == replies_.size()) throw Timeout("the device in this process has nothing to answer");
    const std::size_t count = std::min(bytes.size(), replies_.size() - received_);
    std::ranges::copy(std::span(replies_).subspan(received_, count), bytes.begin());
    received_ += count;
    if (received_ == replies_.size()) {
      replies_.clear();
      received_ = 0;
    }
    return count;
  }

private:
  device::Port port_;
  std::vector<std::uint8_t> replies_;
  std::size_t received_ = 0; ///< bytes of the replies that the host has
};

} // namespace

std::unique_ptr<Link> open_memory_link() { return std::make_unique<MemoryLink>(); }

} // namespace halftone::link
