#include <halftone/serve/session.h>

#include <halftone/protocol/message.h>

#include <cassert>
#include <utility>

namespace halftone::serve {

Session::Session(device::Device& device, recording::Writer* recording, std::string peer)
    : device_(device),
      recording_(recording),
      peer_(std::move(peer)) {
  if (recording_ != nullptr) recording_->begin_session(peer_);
}

void Session::take(std::span<const std::uint8_t> bytes) {
  assert(is_ready());
  if (recording_ != nullptr && !bytes.empty()) recording_->data(bytes);
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
  device_.execute(item, replies_);
  ++items_;
}

void Session::end(std::string_view how) {
  while (!is_ready()) replied(replies().size()); // to nobody
  while (const auto item = decoder_.drain()) execute(*item);
  if (recording_ != nullptr) recording_->end_session(how);
}

void Session::restart() {
  end("the device restarts");
  replied(replies().size());
  decoder_ = protocol::Decoder(protocol::Direction::to_device);
  // What the device remembers is what it remembers after a reset, and a recording can say that.
  if (recording_ != nullptr) recording_->begin_session(peer_);
  std::vector<std::uint8_t> reset;
  append(reset, protocol::Message{protocol::Opcode::reset, 0, {}, {}});
  take(reset);
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
