#pragma once
// Where clients come in.

#include <halftone/file/descriptor.h>
#include <halftone/link/address.h>

#include <sys/types.h>

namespace halftone::serve {

class Listener {
public:
  /// A UNIX or a TCP address; the port 0 is any that is free. A socket file that a server left which is no
  /// more is replaced. Throws link::DeviceError where that cannot be, also where a server listens already,
  /// and std::invalid_argument for other addresses.
  explicit Listener(const link::Address& address);

  /// Takes the socket file away, if it is still the one that was made here.
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// With the port that clients can connect to.
  const link::Address& address() const { return address_; }

  const file::Descriptor& socket() const { return socket_; }

  /// The client that has waited longest, on a socket that does not block; none where it has gone again.
  file::Descriptor accept() const;

private:
  void listen(const link::UnixAddress& address);
  void listen(const link::TcpAddress& address);

  link::Address address_;
  file::Descriptor socket_;
  dev_t file_device_ = 0; ///< of the socket file, and its number
  ino_t file_number_ = 0;
};

} // namespace halftone::serve
