#pragma once
// Sockets of either kind, for both sides: the link that connects and the server that listens.

#include <halftone/file/descriptor.h>
#include <halftone/link/address.h>

#include <chrono>
#include <string>
#include <vector>

#include <sys/socket.h>

namespace halftone::link {

/// As the system calls take it.
struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

SocketAddress resolve(const UnixAddress& address);

/// All addresses of a host, in the order in which they should be tried. Throws DeviceError where there is no
/// such host.
std::vector<SocketAddress> resolve(const TcpAddress& address);

/// The address in numbers.
TcpAddress numbers(const SocketAddress& address);

/// A stream socket for the address that neither blocks nor is inherited. Throws DeviceError.
file::Descriptor open_socket(const SocketAddress& address);

/// Answers and questions are small: they must not wait to be joined with others. Nothing where it is no TCP.
void send_at_once(const file::Descriptor& socket);

/// Connected, within this time for each address that the host has. Throws DeviceError with advice where
/// nobody listens, Timeout.
file::Descriptor connect(const UnixAddress& address, std::chrono::milliseconds timeout);
file::Descriptor connect(const TcpAddress& address, std::chrono::milliseconds timeout);

} // namespace halftone::link
