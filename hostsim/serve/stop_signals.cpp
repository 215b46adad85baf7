#include <halftone/serve/stop_signals.h>

#include <halftone/link/link.h>

#include <cerrno>
#include <cstring>
#include <string>

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace halftone::serve {

namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

StopSignals::StopSignals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGINT);
  ::sigaddset(&signals, SIGTERM);
  if (!is_ignored(SIGHUP)) ::sigaddset(&signals, SIGHUP);
  descriptor_ = file::Descriptor(::signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK));
  if (!descriptor_) throw link::DeviceError(std::string("no signals: ") + std::strerror(errno));
  ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
  struct sigaction ignored {};
  ignored.sa_handler = SIG_IGN;
  ::sigaction(SIGPIPE, &ignored, &pipe_before_);
}

StopSignals::~StopSignals() {
  // Those that came are dealt with; without this the process would die of them now.
  signalfd_siginfo info;
  while (::read(descriptor_.number(), &info, sizeof info) > 0) {
  }
  ::sigaction(SIGPIPE, &pipe_before_, nullptr);
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool StopSignals::have_come() const {
  pollfd entry{descriptor_.number(), POLLIN, 0};
  return ::poll(&entry, 1, 0) == 1;
}

} // namespace halftone::serve
