#include <halftone/link/address.h>

#include <charconv>
#include <limits>
#include <stdexcept>

#include <sys/un.h>

namespace halftone::link {

namespace {

constexpr std::string_view loopback = "127.0.0.1";
constexpr std::size_t longest_socket_path = sizeof(sockaddr_un::sun_path) - 1;

[[noreturn]] void refuse(std::string_view address, const std::string& problem) {
  throw std::invalid_argument("device address \"" + std::string(address) + "\": " + problem);
}

/// What follows the scheme; false where the address has another one.
bool take_scheme(std::string_view scheme, std::string_view address, std::string_view& rest) {
  if (!address.starts_with(scheme)) return false;
  rest = address.substr(scheme.size());
  return true;
}

UnixAddress parse_unix(std::string_view address, std::string_view path) {
  if (path.empty()) refuse(address, "a path is needed, as in unix:m508.socket");
  if (path.find('\0') != path.npos) refuse(address, "a path has no zero bytes");
  if (path.size() > longest_socket_path)
    refuse(address, "the path has " + std::to_string(path.size()) + " bytes, a UNIX socket's at most " +
                        std::to_string(longest_socket_path) + "; a path from the current folder is shorter");
  return {std::string(path)};
}

std::uint16_t parse_port(std::string_view address, std::string_view text) {
  unsigned port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() ||
      port > std::numeric_limits<std::uint16_t>::max())
    refuse(address, "expected a port from 0 to 65535, found \"" + std::string(text) + "\"");
  return static_cast<std::uint16_t>(port);
}

TcpAddress parse_tcp(std::string_view address, std::string_view rest) {
  const std::size_t colon = rest.rfind(':');
  if (colon == rest.npos) refuse(address, "expected tcp:HOST:PORT, as in tcp:127.0.0.1:8508");
  std::string_view host = rest.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']'))
    host = host.substr(1, host.size() - 2);
  else if (host.find(':') != host.npos)
    refuse(address, "an IPv6 number needs brackets, as in tcp:[::1]:8508");
  return {std::string(host.empty() ? loopback : host), parse_port(address, rest.substr(colon + 1))};
}

struct Namer {
  std::string operator()(const MemoryAddress&) const { return "mem:"; }
  std::string operator()(const FileAddress& file) const { return "file:" + file.path; }
  std::string operator()(const PipeAddress&) const { return "pipe:"; }
  std::string operator()(const UnixAddress& socket) const { return "unix:" + socket.path; }
  std::string operator()(const TcpAddress& tcp) const {
    const bool number = tcp.host.find(':') != std::string::npos;
    return "tcp:" + (number ? "[" + tcp.host + "]" : tcp.host) + ":" + std::to_string(tcp.port);
  }
};

} // namespace

Address parse_address(std::string_view text) {
  std::string_view rest;
  if (take_scheme("mem:", text, rest)) {
    if (!rest.empty()) refuse(text, "nothing may follow \"mem:\"");
    return MemoryAddress{};
  }
  if (take_scheme("pipe:", text, rest)) {
    if (!rest.empty()) refuse(text, "nothing may follow \"pipe:\", which is standard output");
    return PipeAddress{};
  }
  if (take_scheme("file:", text, rest)) {
    if (rest.empty()) refuse(text, "a path is needed, as in file:commands.bin");
    return FileAddress{std::string(rest)};
  }
  if (take_scheme("unix:", text, rest)) return parse_unix(text, rest);
  if (take_scheme("tcp:", text, rest)) return parse_tcp(text, rest);
  refuse(text, "not understood; use mem: (the device inside this program), file:PATH, pipe:, unix:PATH or "
               "tcp:HOST:PORT");
}

std::string name(const Address& address) { return std::visit(Namer(), address); }

bool has_way_back(const Address& address) {
  return !std::holds_alternative<FileAddress>(address) && !std::holds_alternative<PipeAddress>(address);
}

} // namespace halftone::link
