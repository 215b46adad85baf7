#include "peer.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <variant>

#include <sys/socket.h>
#include <unistd.h>

namespace halftone::test {

namespace {

void check(int result, const char* what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
}

link::SocketAddress resolved(const link::Address& place) {
  if (const auto* tcp = std::get_if<link::TcpAddress>(&place)) return link::resolve(*tcp).at(0);
  return link::resolve(std::get<link::UnixAddress>(place));
}

} // namespace

Peer::Peer(const link::Address& place, Behaviour behaviour) : address_(place) {
  link::SocketAddress at = resolved(place);
  listener_ = file::Descriptor(::socket(at.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  check(::bind(listener_.number(), at.get(), at.size), "bind");
  check(::listen(listener_.number(), 1), "listen");
  if (std::holds_alternative<link::TcpAddress>(place)) {
    check(::getsockname(listener_.number(), reinterpret_cast<sockaddr*>(&at.storage), &at.size), "name");
    address_ = link::numbers(at);
  }
  thread_ = std::thread([this, behaviour = std::move(behaviour)] {
    const file::Descriptor connection(::accept4(listener_.number(), nullptr, nullptr, SOCK_CLOEXEC));
    if (connection) behaviour(connection.number());
  });
}

Peer::~Peer() {
  ::shutdown(listener_.number(), SHUT_RDWR); // wakes an accept that nobody came to
  thread_.join();
}

std::string read_from(int connection, std::size_t count) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  while (bytes.size() < count) {
    const ssize_t got = ::read(connection, buffer.data(), std::min(buffer.size(), count - bytes.size()));
    if (got <= 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return bytes;
}

void write_to(int connection, const std::string& bytes) {
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const ssize_t count = ::send(connection, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count <= 0) return;
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
}

} // namespace halftone::test
