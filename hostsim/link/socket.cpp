#include <halftone/link/socket.h>

#include "waiting.h"

#include <halftone/link/link.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <thread>

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/un.h>

namespace halftone::link {

namespace {

using Clock = std::chrono::steady_clock;

/// The errno of what came of a connection that was begun; nothing when it is not settled in time.
std::optional<int> outcome(const file::Descriptor& socket, Clock::time_point deadline) {
  if (wait_for(socket, POLLOUT, deadline) == 0) return std::nullopt;
  int error = 0;
  socklen_t size = sizeof error;
  if (::getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size) != 0) return errno;
  return error;
}

/// 0 or an errno; nothing when it takes too long.
std::optional<int> try_connect(const file::Descriptor& socket, const SocketAddress& address,
                               Clock::time_point deadline) {
  while (true) {
    if (::connect(socket.number(), address.get(), address.size) == 0) return 0;
    if (errno == EINPROGRESS || errno == EINTR) return outcome(socket, deadline);
    if (errno != EAGAIN) return errno;
    // A UNIX socket says so while as many clients wait as the server lets wait, and has no way to tell when
    // one of them is served.
    if (Clock::now() >= deadline) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

DeviceError failure(const Address& address, int error) {
  std::string text = "no connection to " + name(address) + ": " + std::strerror(error);
  if (error == ECONNREFUSED || error == ENOENT)
    text += "; a device is started with: m508 serve --listen " + name(address);
  return DeviceError(text);
}

Timeout too_late(const Address& address, std::chrono::milliseconds timeout) {
  return Timeout("no connection to " + name(address) + " within " + std::to_string(timeout.count()) + " ms");
}

} // namespace

SocketAddress resolve(const UnixAddress& address) {
  SocketAddress result;
  sockaddr_un un{};
  un.sun_family = AF_UNIX;
  std::memcpy(un.sun_path, address.path.data(), address.path.size());
  std::memcpy(&result.storage, &un, sizeof un);
  result.size = sizeof un;
  return result;
}

std::vector<SocketAddress> resolve(const TcpAddress& address) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
  if (error != 0)
    throw DeviceError("no host \"" + address.host + "\" for " + name(address) + ": " +
                      (error == EAI_SYSTEM ? std::strerror(errno) : ::gai_strerror(error)));
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
  std::vector<SocketAddress> result;
  for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
    SocketAddress one;
    std::memcpy(&one.storage, entry->ai_addr, entry->ai_addrlen);
    one.size = entry->ai_addrlen;
    result.push_back(one);
  }
  return result;
}

TcpAddress numbers(const SocketAddress& address) {
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  const int error = ::getnameinfo(address.get(), address.size, host.data(), host.size(), port.data(),
                                  port.size(), NI_NUMERICHOST | NI_NUMERICSERV);
  if (error != 0) throw DeviceError(std::string("the address of a socket: ") + ::gai_strerror(error));
  return {host.data(), static_cast<std::uint16_t>(std::stoi(port.data()))};
}

file::Descriptor open_socket(const SocketAddress& address) {
  file::Descriptor socket(::socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket) throw DeviceError(std::string("no socket: ") + std::strerror(errno));
  return socket;
}

void send_at_once(const file::Descriptor& socket) {
  const int on = 1;
  ::setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on); // fails on UNIX sockets, rightly
}

file::Descriptor connect(const UnixAddress& address, std::chrono::milliseconds timeout) {
  const SocketAddress there = resolve(address);
  file::Descriptor socket = open_socket(there);
  const std::optional<int> error = try_connect(socket, there, Clock::now() + timeout);
  if (!error) throw too_late(address, timeout);
  if (*error != 0) throw failure(address, *error);
  return socket;
}

file::Descriptor connect(const TcpAddress& address, std::chrono::milliseconds timeout) {
  std::optional<int> error;
  for (const SocketAddress& there : resolve(address)) {
    file::Descriptor socket = open_socket(there);
    error = try_connect(socket, there, Clock::now() + timeout);
    if (error != 0) continue;
    send_at_once(socket);
    return socket;
  }
  if (!error) throw too_late(address, timeout);
  throw failure(address, *error);
}

} // namespace halftone::link
