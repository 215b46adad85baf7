#include <halftone/serve/session.h>

#include <halftone/protocol/message.h>

#include <cassert>
#include <utility>

namespace halftone::serve {

Session::Session(device::Device& device, Record record) : device_(device), record_(std::move(record)) {}

void Session::take(std::span<const std::uint8_t> bytes) {
  assert(is_ready());
  input_.assign(bytes.begin(), bytes.end());
  executed_ = 0;
  execute();
}

void Session::execute() {
  const std::size_t before = executed_;
  std::span<const std::uint8_t> rest = std::span<const std::uint8_t>(input_).subspan(executed_);
  while (replies().size() < waiting_limit) {
    const auto item = decoder_.next(rest);
    if (!item) break;
    device_.execute(*item, replies_);
  }
  executed_ = input_.size() - rest.size();
  if (record_ && executed_ != before)
    record_(std::span<const std::uint8_t>(input_).subspan(before, executed_ - before));
}

void Session::end_of_input() {
  assert(is_ready());
  while (const auto item = decoder_.drain()) device_.execute(*item, replies_);
}

void Session::restart() {
  input_.clear();
  executed_ = 0;
  replies_.clear();
  replied_ = 0;
  decoder_ = protocol::Decoder(protocol::Direction::to_device);
  // What the device remembers is what it remembers after a reset, and a recording can say that.
  const protocol::Message reset{protocol::Opcode::reset, 0, {}, {}};
  std::vector<std::uint8_t> bytes;
  append(bytes, reset);
  device_.execute({0, bytes.size(), reset}, replies_);
  if (record_) record_(bytes);
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
