#pragma once
// Where a device is, in words.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace halftone::link {

struct MemoryAddress {
  bool operator==(const MemoryAddress&) const = default;
};
struct FileAddress {
  std::string path; ///< not empty
  bool operator==(const FileAddress&) const = default;
};
struct PipeAddress {
  bool operator==(const PipeAddress&) const = default;
};
struct UnixAddress {
  std::string path; ///< not empty, and short enough for a socket
  bool operator==(const UnixAddress&) const = default;
};
struct TcpAddress {
  std::string host; ///< name or number, an IPv6 number without brackets
  std::uint16_t port = 0;
  bool operator==(const TcpAddress&) const = default;
};

using Address = std::variant<MemoryAddress, FileAddress, PipeAddress, UnixAddress, TcpAddress>;

/// "mem:" (a device embedded in this process), "file:PATH", "pipe:" (standard output), "unix:PATH" or
/// "tcp:HOST:PORT", an IPv6 number in brackets; without a host it is 127.0.0.1. Throws std::invalid_argument
/// with advice for any other.
Address parse_address(std::string_view text);

/// The text that parse_address takes.
std::string name(const Address& address);

/// Whether a device there can answer.
bool has_way_back(const Address& address);

} // namespace halftone::link
