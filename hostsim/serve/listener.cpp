#include <halftone/serve/listener.h>

#include <halftone/link/link.h>
#include <halftone/link/socket.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace halftone::serve {

namespace {

/// Clients that may wait for their turn.
constexpr int backlog = 64;

link::DeviceError failure(const link::Address& address, const std::string& why) {
  return link::DeviceError("cannot listen on " + link::name(address) + ": " + why);
}

/// Binds and listens; 0, or the errno of the failure.
int try_listen(const file::Descriptor& socket, const link::SocketAddress& address) {
  if (::bind(socket.number(), address.get(), address.size) != 0) return errno;
  if (::listen(socket.number(), backlog) != 0) return errno;
  return 0;
}

/// The file in the way of a socket: left by a server that is no more, or a reason to give up.
void take_away_stale(const link::UnixAddress& address) {
  struct stat status {};
  if (::lstat(address.path.c_str(), &status) != 0) return; // it has gone by itself
  if (!S_ISSOCK(status.st_mode)) throw failure(address, "there is a file that is no socket");
  const link::SocketAddress there = link::resolve(address);
  const file::Descriptor probe = link::open_socket(there);
  if (::connect(probe.number(), there.get(), there.size) == 0 || errno != ECONNREFUSED)
    throw failure(address, "another process listens there");
  if (::unlink(address.path.c_str()) != 0 && errno != ENOENT) throw failure(address, std::strerror(errno));
}

} // namespace

Listener::Listener(const link::Address& address) : address_(address) {
  if (const auto* socket = std::get_if<link::UnixAddress>(&address))
    listen(*socket);
  else if (const auto* tcp = std::get_if<link::TcpAddress>(&address))
    listen(*tcp);
  else
    throw std::invalid_argument("no client could connect to \"" + link::name(address) +
                                "\"; use unix:PATH or tcp:HOST:PORT");
}

Listener::~Listener() {
  const auto* address = std::get_if<link::UnixAddress>(&address_);
  struct stat status {};
  if (address == nullptr || ::lstat(address->path.c_str(), &status) != 0) return;
  if (status.st_dev == file_device_ && status.st_ino == file_number_) ::unlink(address->path.c_str());
}

void Listener::listen(const link::UnixAddress& address) {
  const link::SocketAddress here = link::resolve(address);
  socket_ = link::open_socket(here);
  int error = try_listen(socket_, here);
  if (error == EADDRINUSE) {
    take_away_stale(address);
    error = try_listen(socket_, here);
  }
  struct stat status {};
  if (error == 0 && ::lstat(address.path.c_str(), &status) != 0) error = errno;
  if (error != 0) throw failure(address, std::strerror(error));
  file_device_ = status.st_dev;
  file_number_ = status.st_ino;
}

void Listener::listen(const link::TcpAddress& address) {
  int error = EADDRNOTAVAIL;
  for (link::SocketAddress& here : link::resolve(address)) {
    socket_ = link::open_socket(here);
    const int on = 1; // connections of a server before it may linger, and do no harm
    ::setsockopt(socket_.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    error = try_listen(socket_, here);
    if (error != 0) continue;
    if (::getsockname(socket_.number(), reinterpret_cast<sockaddr*>(&here.storage), &here.size) != 0) break;
    address_ = link::numbers(here);
    return;
  }
  throw failure(address, error == EADDRINUSE ? "another process listens there" : std::strerror(error));
}

file::Descriptor Listener::accept() const {
  file::Descriptor client(::accept4(socket_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (client) {
    link::send_at_once(client);
    const int on = 1; // a client whose machine went off must not keep others waiting for ever
    ::setsockopt(client.number(), SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  } else if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR && errno != ECONNABORTED) {
    throw failure(address_, std::strerror(errno));
  }
  return client;
}

} // namespace halftone::serve
