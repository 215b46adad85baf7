#pragma once
// The other side of a socket link, for tests: listens, and does with its client what it is told.

#include <halftone/link/socket.h>

#include <functional>
#include <string>
#include <thread>

namespace halftone::test {

/// What the other side does with the connection; it is closed afterwards.
using Behaviour = std::function<void(int connection)>;

class Peer {
public:
  /// Serves one client of a socket in this place in a thread; port 0 is any that is free.
  Peer(const link::Address& place, Behaviour behaviour);
  ~Peer(); ///< waits for it
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  std::string address() const { return link::name(address_); }

private:
  link::Address address_;
  file::Descriptor listener_;
  std::thread thread_;
};

/// Reads so many bytes, or until the end.
std::string read_from(int connection, std::size_t count);
void write_to(int connection, const std::string& bytes);

} // namespace halftone::test
