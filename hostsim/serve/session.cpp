#include <halftone/serve/session.h>

#include <halftone/protocol/message.h>

#include <cassert>
#include <utility>

namespace halftone::serve {

Session::Session(device::Device& device, recording::Writer* recording, std::string peer)
    : device_(device),
      recording_(recording),
      peer_(std::move(peer)) {}

void Session::take(std::span<const std::uint8_t> bytes) {
  assert(is_ready());
  if (bytes.empty()) return;
  if (recording_ != nullptr) {
    if (!std::exchange(is_begun_, true)) recording_->begin_session(peer_);
    recording_->data(bytes);
  }
  input_.assign(bytes.begin(), bytes.end());
  executed_ = 0;
  execute();
}

void Session::execute() {
  std::span<const std::uint8_t> rest = std::span<const std::uint8_t>(input_).subspan(executed_);
  while (replies().size() < waiting_limit) {
    const auto item = decoder_.next(rest);
    if (!item) break;
    execute(*item);
  }
  executed_ = input_.size() - rest.size();
}

void Session::execute(const protocol::Item& item) {
  if (is_deaf_)
    device_.execute(item);
  else
    device_.execute(item, replies_);
  if (recording_ != nullptr) recording_->executed(item, device_);
}

void Session::stop_answering() {
  is_deaf_ = true;
  replies_.clear();
  replied_ = 0;
  execute();
}

void Session::interrupt(std::span<const std::uint8_t> commands, std::string_view who) {
  assert(is_interruptible());
  if (recording_ != nullptr) {
    if (std::exchange(is_begun_, false)) recording_->end_session("interrupted");
    recording_->begin_session(who);
    recording_->data(commands);
  }
  protocol::Decoder decoder(protocol::Direction::to_device);
  while (const auto item = decoder.next(commands)) {
    device_.execute(*item);
    if (recording_ != nullptr) recording_->executed(*item, device_);
  }
  if (recording_ != nullptr) recording_->end_session("done");
}

void Session::restart() {
  const bool was_deaf = is_deaf_;
  end("the device restarts");
  is_deaf_ = was_deaf;
  decoder_ = protocol::Decoder(protocol::Direction::to_device);
  if (recording_ != nullptr) recording_->restart();
  execute(recording::restart_item());
}

void Session::end(std::string_view how) {
  stop_answering();
  while (const auto item = decoder_.drain()) execute(*item);
  if (std::exchange(is_begun_, false)) recording_->end_session(how);
}

std::span<const std::uint8_t> Session::replies() const {
  return std::span<const std::uint8_t>(replies_).subspan(replied_);
}

void Session::replied(std::size_t count) {
  replied_ += count;
  assert(replied_ <= replies_.size());
  if (replied_ == replies_.size()) {
    replies_.clear();
    replied_ = 0;
  }
  if (is_ready() && replied_ < waiting_limit) return;
  // What is with the client must not pile up while the rest never quite empties.
  replies_.erase(replies_.begin(), replies_.begin() + static_cast<std::ptrdiff_t>(replied_));
  replied_ = 0;
  execute();
}

} // namespace halftone::serve
