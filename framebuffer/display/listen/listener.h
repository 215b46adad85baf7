#pragma once
// Where displays wait for those who come by network: on loopback, unless another address is asked for.

#include <halftone/file/descriptor.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace halftone::display {

struct Endpoint {
  std::string host; ///< name or number, an IPv6 number without brackets
  std::uint16_t port = 0;

  bool operator==(const Endpoint&) const = default;
};

/// "HOST:PORT", an IPv6 number in brackets; without a host it is 127.0.0.1, and all of "" stands for that and
/// the usual port. Throws std::invalid_argument with advice, which begins with the display's name.
Endpoint parse_endpoint(std::string_view display, std::string_view text, std::uint16_t usual_port);

/// The text that parse_endpoint takes.
std::string name(const Endpoint& endpoint);

/// Listens to TCP; does not wait.
class Listener {
public:
  /// Port 0 takes one that is free. Throws DisplayError.
  Listener(std::string_view display, const Endpoint& endpoint);

  /// With the port that it is.
  const Endpoint& endpoint() const { return endpoint_; }

  /// Whoever has come next; nothing where nobody has.
  file::Descriptor accept() const;

  /// To hand on.
  const file::Descriptor& descriptor() const { return descriptor_; }

private:
  Endpoint endpoint_;
  file::Descriptor descriptor_;
};

} // namespace halftone::display
