// A client that has gone without taking its replies may have left commands: they are executed, without
// replies, until the end of what it sent.

#include "connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <poll.h>
#include <sys/socket.h>

namespace halftone::serve {

namespace {

/// Of the replies where faults are injected, for a piece is what gets lost at once.
constexpr std::size_t faulty_piece = 1000;

bool is_passing(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

} // namespace

Connection::Connection(file::Descriptor socket, Session& session, const std::optional<link::Faults>& faults,
                       std::chrono::milliseconds patience)
    : patience_(patience),
      socket_(std::move(socket)),
      session_(session) {
  if (faults) cable_.emplace(*faults);
}

Connection::Wish Connection::wish() const {
  Wish wish{.from = quiet_until_};
  if (waits_to_write()) {
    wish.events |= POLLOUT;
    wish.until = give_up_;
  }
  if (!is_done_ && session_.is_ready() && session_.replies().size() < waiting_limit) wish.events |= POLLIN;
  return wish;
}

void Connection::proceed(std::size_t most) {
  const auto now = Clock::now();
  if (!waits_to_write() || now < quiet_until_) give_up_ = now + patience_;
  if ((wish().events & POLLIN) != 0) read(most);
  if (Clock::now() >= quiet_until_) write();
  if (waits_to_write() ? Clock::now() >= give_up_ : is_done_) is_over_ = true;
}

bool Connection::waits_to_write() const { return gone_ != outgoing_.size() || !session_.replies().empty(); }

void Connection::read(std::size_t most) {
  std::array<std::uint8_t, largest_read> buffer;
  const ssize_t count = ::recv(socket_.number(), buffer.data(), std::min(most, buffer.size()), 0);
  if (count < 0 && is_passing(errno)) return;
  if (count <= 0) {
    is_done_ = true;
    return;
  }
  has_spoken_ = true;
  const std::span<const std::uint8_t> bytes = std::span(buffer).first(static_cast<std::size_t>(count));
  if (!cable_) return session_.take(bytes);
  const link::Passed passed = cable_->pass(bytes);
  session_.take(passed.bytes);
  settle(passed);
}

/// One piece, so that a client that is quick to read cannot keep the server from anything else.
void Connection::write() {
  if (is_over_ || !fill_outgoing() || Clock::now() < quiet_until_) return;
  const ssize_t count =
      ::send(socket_.number(), outgoing_.data() + gone_, outgoing_.size() - gone_, MSG_NOSIGNAL);
  if (count >= 0) {
    gone_ += static_cast<std::size_t>(count);
    give_up_ = Clock::now() + patience_;
  } else if (!is_passing(errno)) {
    stop_answering();
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
  if (passed.closed) is_over_ = true;
}

void Connection::stop_answering() {
  outgoing_.clear();
  gone_ = 0;
  session_.stop_answering();
}

} // namespace halftone::serve
