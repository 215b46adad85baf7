#include "listener.h"

#include <halftone/display/display.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace halftone::display {

namespace {

constexpr std::string_view loopback = "127.0.0.1";
constexpr int most_waiting = 16;

std::uint16_t port_of(const sockaddr_storage& address) {
  in_port_t port = 0;
  if (address.ss_family == AF_INET6)
    port = reinterpret_cast<const sockaddr_in6&>(address).sin6_port;
  else
    port = reinterpret_cast<const sockaddr_in&>(address).sin_port;
  return ntohs(port);
}

/// Nothing, and errno, where it cannot be.
file::Descriptor listen_at(const addrinfo& address) {
  file::Descriptor socket(::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int on = 1;
  // A port that was left a moment ago is free.
  if (socket && ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
      ::bind(socket.number(), address.ai_addr, address.ai_addrlen) == 0 &&
      ::listen(socket.number(), most_waiting) == 0)
    return socket;
  return file::Descriptor();
}

} // namespace

Endpoint parse_endpoint(std::string_view display, std::string_view text, std::uint16_t usual_port) {
  if (text.empty()) return {std::string(loopback), usual_port};
  const auto refuse = [&](const std::string& problem) {
    throw std::invalid_argument("display " + std::string(display) + ": " + problem + ", as in " +
                                std::string(display) + ":127.0.0.1:" + std::to_string(usual_port) +
                                "; found \"" + std::string(text) + '"');
  };
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos) refuse("expected HOST:PORT");
  std::string_view host = text.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']'))
    host = host.substr(1, host.size() - 2);
  else if (host.find(':') != host.npos)
    refuse("an IPv6 number needs brackets");
  unsigned port = 0;
  const auto [end, error] = std::from_chars(&text[colon] + 1, text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size() ||
      port > std::numeric_limits<std::uint16_t>::max())
    refuse("expected a port from 0 to 65535");
  return {std::string(host.empty() ? loopback : host), static_cast<std::uint16_t>(port)};
}

std::string name(const Endpoint& endpoint) {
  const bool is_ipv6 = endpoint.host.find(':') != std::string::npos;
  return (is_ipv6 ? '[' + endpoint.host + ']' : endpoint.host) + ':' + std::to_string(endpoint.port);
}

Listener::Listener(std::string_view display, const Endpoint& endpoint) : endpoint_(endpoint) {
  const auto fail = [&](const std::string& why) {
    throw DisplayError("display " + std::string(display) + ": cannot listen on " + name(endpoint) + ": " +
                       why);
  };
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error =
      ::getaddrinfo(endpoint.host.c_str(), std::to_string(endpoint.port).c_str(), &wanted, &found);
  if (error != 0) fail(::gai_strerror(error));
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, ::freeaddrinfo);
  for (const addrinfo* address = found; address != nullptr && !descriptor_; address = address->ai_next)
    descriptor_ = listen_at(*address);
  if (!descriptor_ && errno == EADDRINUSE)
    fail("another process listens there; port 0 takes one that is free");
  if (!descriptor_) fail(std::strerror(errno));

  sockaddr_storage taken{};
  socklen_t size = sizeof taken;
  if (::getsockname(descriptor_.number(), reinterpret_cast<sockaddr*>(&taken), &size) != 0)
    fail(std::strerror(errno));
  endpoint_.port = port_of(taken);
}

file::Descriptor Listener::accept() const {
  return file::Descriptor(::accept4(descriptor_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
}

} // namespace halftone::display
