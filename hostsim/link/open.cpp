#include "file_link.h"
#include "memory_link.h"
#include "socket_link.h"
#include "stream_link.h"

#include <halftone/link/link.h>
#include <halftone/link/socket.h>

#include <variant>

namespace halftone::link {

namespace {

struct Opener {
  std::chrono::milliseconds timeout;

  std::unique_ptr<Link> operator()(const MemoryAddress&) const { return open_memory_link(); }
  std::unique_ptr<Link> operator()(const FileAddress& file) const { return open_file_link(file.path); }
  std::unique_ptr<Link> operator()(const PipeAddress&) const { return open_pipe_link(timeout); }
  std::unique_ptr<Link> operator()(const UnixAddress& address) const {
    return open_socket_link(connect(address, timeout), timeout);
  }
  std::unique_ptr<Link> operator()(const TcpAddress& address) const {
    return open_socket_link(connect(address, timeout), timeout);
  }
};

} // namespace

std::unique_ptr<Link> open(const Address& address, std::chrono::milliseconds timeout) {
  return std::visit(Opener{timeout}, address);
}

std::unique_ptr<Link> open(const std::string& address, std::chrono::milliseconds timeout) {
  return open(parse_address(address), timeout);
}

} // namespace halftone::link
