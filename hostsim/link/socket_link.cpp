// Sending takes in what the device answers meanwhile: a device that cannot get its answers away stops
// reading, and if the host did the same, both would wait for each other for ever.

#include "socket_link.h"

#include "waiting.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/socket.h>

namespace halftone::link {

namespace {

using Clock = std::chrono::steady_clock;

/// Answers that are kept while sending. A device that has more to say than this to what a host asks without
/// listening has lost its mind.
constexpr std::size_t kept_limit = std::size_t{64} << 20;

class SocketLink final : public Link {
public:
  SocketLink(file::Descriptor socket, std::chrono::milliseconds timeout)
      : socket_(std::move(socket)),
        timeout_(timeout) {}

  void send(std::span<const std::uint8_t> bytes) override {
    auto deadline = Clock::now() + timeout_;
    while (!bytes.empty()) {
      const ssize_t count = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count > 0) {
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        deadline = Clock::now() + timeout_;
        continue;
      }
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK) throw broken(errno);
      const short events = wait_for(socket_, POLLIN | POLLOUT, deadline);
      if (events == 0)
        throw Timeout("the device took nothing for " + std::to_string(timeout_.count()) + " ms");
      if ((events & POLLIN) != 0) keep_answers();
    }
  }

  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    if (given_ != kept_.size()) return give_kept(bytes);
    const auto deadline = Clock::now() + timeout;
    while (true) {
      if (const std::size_t count = read_some(bytes); count > 0) return count;
      if (wait_for(socket_, POLLIN, deadline) == 0)
        throw Timeout("the device said nothing for " + std::to_string(timeout.count()) + " ms");
    }
  }

  void cut() override { ::shutdown(socket_.number(), SHUT_RDWR); }

private:
  static DeviceError broken(int error) {
    if (error == EPIPE || error == ECONNRESET) return DeviceError("the device closed the connection");
    return DeviceError(std::string("the connection to the device broke: ") + std::strerror(error));
  }

  /// 0 where nothing has come yet.
  std::size_t read_some(std::span<std::uint8_t> bytes) {
    while (true) {
      const ssize_t count = ::recv(socket_.number(), bytes.data(), bytes.size(), 0);
      if (count > 0) return static_cast<std::size_t>(count);
      if (count == 0) throw DeviceError("the device closed the connection");
      if (errno == EAGAIN || errno == EWOULDBLOCK) return 0;
      if (errno != EINTR) throw broken(errno);
    }
  }

  void keep_answers() {
    std::array<std::uint8_t, 1 << 16> buffer;
    const std::size_t count = read_some(buffer);
    if (kept_.size() - given_ + count > kept_limit)
      throw DeviceError("the device sends without end, whatever it is asked");
    kept_.insert(kept_.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
  }

  std::size_t give_kept(std::span<std::uint8_t> bytes) {
    const std::size_t count = std::min(bytes.size(), kept_.size() - given_);
    std::ranges::copy(std::span(kept_).subspan(given_, count), bytes.begin());
    given_ += count;
    if (given_ == kept_.size()) {
      kept_.clear();
      given_ = 0;
    }
    return count;
  }

  file::Descriptor socket_;
  std::chrono::milliseconds timeout_;
  std::vector<std::uint8_t> kept_; ///< answers that came while sending
  std::size_t given_ = 0;          ///< how many of their bytes the host has
};

} // namespace

std::unique_ptr<Link> open_socket_link(file::Descriptor socket, std::chrono::milliseconds timeout) {
  return std::make_unique<SocketLink>(std::move(socket), timeout);
}

} // namespace halftone::link
