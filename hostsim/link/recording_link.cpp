#include <halftone/link/recording_link.h>

#include <utility>

namespace halftone::link {

RecordingLink::RecordingLink(std::unique_ptr<Link> over, recording::Writer& recording, std::string_view peer)
    : over_(std::move(over)),
      recording_(recording) {
  recording_.begin_session(peer);
}

void RecordingLink::record(std::span<const std::uint8_t> bytes) {
  recording_.data(bytes);
  for (auto rest = bytes; const auto item = decoder_.next(rest);) {
    device_.execute(*item);
    recording_.executed(*item, device_);
  }
}

void RecordingLink::send(std::span<const std::uint8_t> bytes) {
  if (failure_) std::rethrow_exception(failure_);
  try {
    record(bytes);
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
  over_->send(bytes);
}

std::size_t RecordingLink::receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) {
  return over_->receive(bytes, timeout);
}

bool RecordingLink::has_way_back() const { return over_->has_way_back(); }

void RecordingLink::finish() { over_->finish(); }

void RecordingLink::cut() { over_->cut(); }

void RecordingLink::end(std::string_view how) {
  if (failure_) return recording_.end_session(how); // device_ may not have executed what is recorded
  while (const auto item = decoder_.drain()) {
    device_.execute(*item);
    recording_.executed(*item, device_);
  }
  recording_.end_session(how);
  recording_.state(device_);
}

} // namespace halftone::link
