#pragma once
// Signals that ask a server to end, as something that poll(2) can wait for.

#include <halftone/file/descriptor.h>

#include <csignal>

namespace halftone::serve {

/// While it lives, SIGINT, SIGTERM and, unless it was ignored before (nohup), SIGHUP do not end the process:
/// they make the descriptor readable. Nor does SIGPIPE: output that nobody reads, or a display that has gone,
/// is an error of whoever writes to it, and no reason to die with other files unwritten. For the only thread
/// of a process, or before others are started.
class StopSignals {
public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether one has come.
  bool have_come() const;

  const file::Descriptor& descriptor() const { return descriptor_; }

private:
  sigset_t before_{};
  struct sigaction pipe_before_ {};
  file::Descriptor descriptor_;
};

} // namespace halftone::serve
