// A client that has gone without taking its replies may have left commands: they are executed, and their
// replies dropped, until the end of what it sent.

#include "connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <poll.h>
#include <sys/socket.h>

namespace halftone::serve {

namespace {

/// Few enough that the commands in them are done in a moment, so that a signal is not kept waiting.
constexpr std::size_t largest_read = 1 << 15;

/// Of the replies where faults are injected, for a piece is what gets lost at once.
constexpr std::size_t faulty_piece = 1000;

/// For a client that has ended its side to take the next bytes of what it asked for.
constexpr auto patience = std::chrono::seconds(10);

bool is_passing(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

} // namespace

Connection::Connection(link::Descriptor socket, Session& session, const std::optional<link::Faults>& faults)
    : socket_(std::move(socket)),
      session_(session) {
  if (faults) cable_.emplace(*faults);
}

Connection::Wish Connection::wish() const {
  Wish wish{.from = quiet_until_};
  const bool waits_to_write = gone_ != outgoing_.size() || !session_.replies().empty();
  if (waits_to_write) wish.events |= POLLOUT;
  if (!is_done_ && session_.is_ready() && session_.replies().size() < waiting_limit) wish.events |= POLLIN;
  if (is_done_) wish.until = give_up_;
  return wish;
}

void Connection::proceed() {
  if (is_done_ && Clock::now() >= give_up_) is_deaf_ = true;
  if ((wish().events & POLLIN) != 0) read();
  if (Clock::now() >= quiet_until_) write();
  if (is_done_ && gone_ == outgoing_.size() && session_.replies().empty()) is_over_ = true;
}

void Connection::read() {
  std::array<std::uint8_t, largest_read> buffer;
  const ssize_t count = ::recv(socket_.number(), buffer.data(), buffer.size(), 0);
  if (count < 0 && is_passing(errno)) return;
  if (count <= 0) return end_input();
  has_spoken_ = true;
  const std::span<const std::uint8_t> bytes = std::span(buffer).first(static_cast<std::size_t>(count));
  if (!cable_) return session_.take(bytes);
  const link::Passed passed = cable_->pass(bytes);
  session_.take(passed.bytes);
  settle(passed);
}

/// One piece, so that a client that is quick to read cannot keep the server from anything else.
void Connection::write() {
  while (is_deaf_ && fill_outgoing()) gone_ = outgoing_.size();
  if (is_over_ || !fill_outgoing() || Clock::now() < quiet_until_) return;
  const ssize_t count =
      ::send(socket_.number(), outgoing_.data() + gone_, outgoing_.size() - gone_, MSG_NOSIGNAL);
  if (count >= 0) {
    gone_ += static_cast<std::size_t>(count);
    give_up_ = Clock::now() + patience;
  } else if (!is_passing(errno)) {
    is_deaf_ = true;
    write();
  }
}

/// Whether there is something to send.
bool Connection::fill_outgoing() {
  if (gone_ != outgoing_.size()) return true;
  outgoing_.clear();
  gone_ = 0;
  const std::span<const std::uint8_t> replies = session_.replies();
  const std::span<const std::uint8_t> piece =
      cable_ ? replies.first(std::min(replies.size(), faulty_piece)) : replies;
  const std::size_t size = piece.size();
  if (size == 0) return false;
  if (!cable_) {
    outgoing_.assign(piece.begin(), piece.end());
    session_.replied(size);
    return true;
  }
  link::Passed passed = cable_->pass(piece);
  session_.replied(size);
  outgoing_ = std::move(passed.bytes);
  settle(passed);
  return !outgoing_.empty();
}

void Connection::settle(const link::Passed& passed) {
  quiet_until_ = std::max(quiet_until_, Clock::now() + passed.delay);
  if (passed.restarted) session_.restart();
  if (!passed.closed) return;
  is_deaf_ = true;
  is_over_ = true;
}

void Connection::end_input() {
  is_done_ = true;
  give_up_ = Clock::now() + patience;
}

} // namespace halftone::serve
