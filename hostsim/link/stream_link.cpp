#include "stream_link.h"

#include "waiting.h"

#include <halftone/file/descriptor.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace halftone::link {

namespace {

using Clock = std::chrono::steady_clock;

/// While it lives, a write of this thread into a pipe without a reader is an error and no signal. What the
/// process does about SIGPIPE elsewhere stays as it is.
class WithoutPipeSignal {
public:
  WithoutPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutPipeSignal() {
    const timespec at_once{};
    if (!was_pending_)
      while (::sigtimedwait(&pipe_, nullptr, &at_once) < 0 && errno == EINTR) {
      }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

constexpr std::string_view out_name = "standard output";

class StreamLink final : public Link {
public:
  StreamLink(file::Descriptor stream, std::chrono::milliseconds timeout)
      : stream_(std::move(stream)),
        timeout_(timeout) {}

  void send(std::span<const std::uint8_t> bytes) override {
    const WithoutPipeSignal shelter;
    while (!bytes.empty()) {
      if (wait_for(stream_, POLLOUT, Clock::now() + timeout_) == 0)
        throw Timeout(std::string(out_name) + " took nothing for " + std::to_string(timeout_.count()) +
                      " ms");
      // No more than a pipe that is ready takes without blocking.
      const std::size_t piece = std::min<std::size_t>(bytes.size(), PIPE_BUF);
      const ssize_t count = ::write(stream_.number(), bytes.data(), piece);
      if (count > 0)
        bytes = bytes.subspan(static_cast<std::size_t>(count));
      else if (count < 0 && errno == EPIPE)
        throw DeviceError(std::string(out_name) + ": the program that reads it has ended");
      else if (count < 0 && errno != EINTR && errno != EAGAIN)
        throw DeviceError(std::string(out_name) + " cannot be written: " + std::strerror(errno));
    }
  }

  std::size_t receive(std::span<std::uint8_t>, std::chrono::milliseconds) override {
    throw DeviceError(std::string(out_name) + " has no way back");
  }

  bool has_way_back() const override { return false; }

private:
  file::Descriptor stream_;
  std::chrono::milliseconds timeout_;
};

} // namespace

std::unique_ptr<Link> open_pipe_link(std::chrono::milliseconds timeout) {
  if (::isatty(STDOUT_FILENO) == 1)
    throw DeviceError("standard output is a terminal; commands go to a program or a file, as with > FILE");
  file::Descriptor out(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0));
  if (!out) throw DeviceError(std::string("standard output: ") + std::strerror(errno));
  return std::make_unique<StreamLink>(std::move(out), timeout);
}

} // namespace halftone::link
