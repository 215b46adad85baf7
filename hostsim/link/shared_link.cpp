#include <halftone/link/shared_link.h>

#include <algorithm>

namespace halftone::link {

namespace {

/// How long somebody who sends may have to wait for somebody who receives.
constexpr std::chrono::milliseconds turn(5);

} // namespace

void SharedLink::send(std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  over_->send(bytes);
}

std::size_t SharedLink::receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + timeout;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    try {
      const std::lock_guard lock(mutex_);
      return over_->receive(bytes, std::clamp(left, std::chrono::milliseconds(0), turn));
    } catch (const Timeout&) {
      if (left <= turn) throw;
    }
  }
}

bool SharedLink::has_way_back() const { return over_->has_way_back(); }

void SharedLink::finish() { over_->finish(); }

void SharedLink::cut() { over_->cut(); }

} // namespace halftone::link
