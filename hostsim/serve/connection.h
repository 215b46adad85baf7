#pragma once
// A session over a socket, with what may go wrong there.

#include <halftone/serve/session.h>

#include <halftone/file/descriptor.h>
#include <halftone/link/faults.h>

#include <chrono>
#include <optional>
#include <vector>

namespace halftone::serve {

using Clock = std::chrono::steady_clock;

class Connection {
public:
  /// The session must outlive it. Faults are injected into what passes. `patience` as in Settings (server.h).
  Connection(file::Descriptor socket, Session& session, const std::optional<link::Faults>& faults,
             std::chrono::milliseconds patience);

  const file::Descriptor& socket() const { return socket_; }

  /// What to wait for: poll(2) events, none of them before `from`, and no longer than until `until`.
  struct Wish {
    short events = 0;
    Clock::time_point from;
    Clock::time_point until = Clock::time_point::max();
  };
  Wish wish() const;

  /// Few enough that a signal is kept waiting for about 0.2 s at the most, by the slowest commands of which
  /// so many bytes can be made: 163 copies of the whole screen through a write mask, 1.3 ms each.
  static constexpr std::size_t largest_read = 1 << 12;

  /// Reads and writes what can be without waiting, reads no more than so much.
  void proceed(std::size_t most = largest_read);

  /// Nothing more will come of it.
  bool is_over() const { return is_over_; }

  /// Whether the client ever sent anything.
  bool has_spoken() const { return has_spoken_; }

private:
  void read(std::size_t most);
  void write();
  void stop_answering();
  bool waits_to_write() const;
  void settle(const link::Passed& passed);
  bool fill_outgoing();

  std::chrono::milliseconds patience_;
  file::Descriptor socket_;
  Session& session_;
  std::optional<link::FaultyCable> cable_;
  std::vector<std::uint8_t> outgoing_; ///< replies on their way
  std::size_t gone_ = 0;               ///< bytes of them that are with the client
  Clock::time_point quiet_until_;      ///< a delay that is injected
  Clock::time_point give_up_;          ///< unless the client takes something before
  bool has_spoken_ = false;
  bool is_done_ = false; ///< the client sends no more
  bool is_over_ = false;
};

} // namespace halftone::serve
