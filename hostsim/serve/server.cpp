#include <halftone/serve/server.h>

#include "connection.h"

#include <halftone/link/link.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <poll.h>

namespace halftone::serve {

namespace {

using std::chrono::milliseconds;

/// Waits for events, for `stop`, or for the time; whether it is time to stop.
bool wait(const link::Descriptor& stop, const link::Descriptor& socket, short events,
          Clock::time_point until) {
  constexpr milliseconds longest = std::chrono::hours(1); // poll takes an int
  const auto left =
      until == Clock::time_point::max() ? longest : std::chrono::ceil<milliseconds>(until - Clock::now());
  // Without events the socket is left out, or its end would be told again and again.
  std::array<pollfd, 2> entries{
      {{stop.number(), POLLIN, 0}, {events == 0 ? -1 : socket.number(), events, 0}}};
  const auto time = static_cast<int>(std::clamp(left, milliseconds(0), longest).count());
  if (::poll(entries.data(), entries.size(), time) < 0 && errno != EINTR)
    throw link::DeviceError(std::string("waiting for clients: ") + std::strerror(errno));
  return entries[0].revents != 0;
}

enum class Ended { gone, stopped };

Ended serve_client(Connection& connection, const link::Descriptor& stop) {
  while (!connection.is_over()) {
    const Connection::Wish wish = connection.wish();
    const bool is_early = Clock::now() < wish.from;
    if (wait(stop, connection.socket(), is_early ? short{0} : wish.events, is_early ? wish.from : wish.until))
      return Ended::stopped;
    connection.proceed();
  }
  return Ended::gone;
}

} // namespace

void serve(const Listener& listener, device::Device& device, const Settings& settings,
           recording::Writer* recording, const link::Descriptor& stop) {
  std::uint64_t clients = 0;
  while (!wait(stop, listener.socket(), POLLIN, Clock::time_point::max())) {
    link::Descriptor client = listener.accept();
    if (!client) continue;
    Session session(device, recording, "client " + std::to_string(clients + 1));
    std::optional<link::Faults> faults;
    if (settings.fault_seed) faults = link::faults_of(*settings.fault_seed + clients);
    Connection connection(std::move(client), session, faults, settings.patience);
    const Ended ended = serve_client(connection, stop);
    session.end(ended == Ended::stopped ? "the server was stopped" : "the client has gone");
    if (recording != nullptr && connection.has_spoken()) recording->state(device);
    if (ended == Ended::stopped) return;
    if (!connection.has_spoken()) continue; // a server that asks whether anybody listens here
    ++clients;
    if (settings.once) return;
  }
}

} // namespace halftone::serve
