#include <halftone/serve/server.h>

#include "connection.h"

#include <halftone/link/link.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

#include <poll.h>

namespace halftone::serve {

namespace {

using std::chrono::milliseconds;

/// In recordings.
constexpr std::string_view console_name = "console";

enum class Woken { by_stop, by_console, otherwise };

/// Waits for events, for `stop`, for the console where it is not null, or for the time.
Woken wait(const file::Descriptor& stop, const Console* console, const file::Descriptor& socket, short events,
           Clock::time_point until) {
  constexpr milliseconds longest = std::chrono::hours(1); // poll takes an int
  const auto left =
      until == Clock::time_point::max() ? longest : std::chrono::ceil<milliseconds>(until - Clock::now());
  // Without events the socket is left out, or its end would be told again and again.
  std::array<pollfd, 3> entries{{{stop.number(), POLLIN, 0},
                                 {console == nullptr ? -1 : console->descriptor().number(), POLLIN, 0},
                                 {events == 0 ? -1 : socket.number(), events, 0}}};
  const auto time = static_cast<int>(std::clamp(left, milliseconds(0), longest).count());
  if (::poll(entries.data(), entries.size(), time) < 0 && errno != EINTR)
    throw link::DeviceError(std::string("waiting for clients: ") + std::strerror(errno));
  if (entries[0].revents != 0) return Woken::by_stop;
  return entries[1].revents != 0 ? Woken::by_console : Woken::otherwise;
}

enum class Ended { gone, stopped };

Ended serve_client(Connection& connection, Session& session, const file::Descriptor& stop, Console* console) {
  while (!connection.is_over()) {
    const bool is_asked = console != nullptr && console->is_waiting();
    if (is_asked && session.is_interruptible()) {
      session.interrupt(console->take(), console_name);
      continue;
    }
    const Connection::Wish wish = connection.wish();
    const bool is_early = Clock::now() < wish.from;
    const Woken woken = wait(stop, is_asked ? nullptr : console, connection.socket(),
                             is_early ? short{0} : wish.events, is_early ? wish.from : wish.until);
    if (woken == Woken::by_stop) return Ended::stopped;
    // Where the console waits, no further than to the end of the client's command.
    if (woken == Woken::otherwise)
      connection.proceed(is_asked && session.missing() != 0 ? session.missing() : Connection::largest_read);
  }
  return Ended::gone;
}

} // namespace

void serve(const Listener& listener, device::Device& device, const Settings& settings,
           recording::Writer* recording, const file::Descriptor& stop, Console* console) {
  std::uint64_t clients = 0;
  while (true) {
    const Woken woken = wait(stop, console, listener.socket(), POLLIN, Clock::time_point::max());
    if (woken == Woken::by_stop) return;
    if (woken == Woken::by_console) {
      Session(device, recording, {}).interrupt(console->take(), console_name);
      continue;
    }
    file::Descriptor client = listener.accept();
    if (!client) continue;
    Session session(device, recording, "client " + std::to_string(clients + 1));
    std::optional<link::Faults> faults;
    if (settings.fault_seed) faults = link::faults_of(*settings.fault_seed + clients);
    Connection connection(std::move(client), session, faults, settings.patience);
    const Ended ended = serve_client(connection, session, stop, console);
    session.end(ended == Ended::stopped ? "the server was stopped" : "the client has gone");
    if (recording != nullptr && connection.has_spoken()) recording->state(device);
    if (ended == Ended::stopped) return;
    if (!connection.has_spoken()) continue; // a server that asks whether anybody listens here
    ++clients;
    if (settings.once) return;
  }
}

} // namespace halftone::serve
