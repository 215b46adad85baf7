#include "support/scratch.h"

#include <halftone/link/link.h>
#include <halftone/link/socket.h>
#include <halftone/serve/listener.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <memory>
#include <string>

#include <sys/socket.h>

using namespace halftone;
using serve::Listener;
using test::Scratch;

namespace {

/// The socket file of a server that died without taking it away.
void leave_stale_socket(const std::string& path) {
  const link::SocketAddress at = link::resolve(link::UnixAddress{path});
  const file::Descriptor socket = link::open_socket(at);
  REQUIRE(::bind(socket.number(), at.get(), at.size) == 0);
}

} // namespace

TEST_CASE("a listener names the port that it got, and takes a client") {
  const Listener listener(link::TcpAddress{"127.0.0.1", 0});
  const auto& address = std::get<link::TcpAddress>(listener.address());
  CHECK(address.host == "127.0.0.1");
  CHECK(address.port > 0);
  CHECK_FALSE(listener.accept()); // and does not wait for one
  const auto client = link::open(listener.address());
  CHECK(listener.accept());
}

TEST_CASE("a socket file comes and goes with its listener") {
  const Scratch scratch;
  {
    const Listener listener(link::UnixAddress{scratch / "s"});
    CHECK(scratch.names() == std::vector<std::string>{"s"});
    const auto client = link::open(listener.address());
    CHECK(listener.accept());
  }
  CHECK(scratch.names().empty());
}

TEST_CASE("the socket file of a server that is no more is replaced") {
  const Scratch scratch;
  leave_stale_socket(scratch / "s");
  const Listener listener(link::UnixAddress{scratch / "s"});
  const auto client = link::open(listener.address());
  CHECK(listener.accept());
}

TEST_CASE("where a server listens no other one can, and the first stays") {
  const Scratch scratch;
  for (const link::Address& address :
       {link::Address(link::UnixAddress{scratch / "s"}), link::Address(link::TcpAddress{"127.0.0.1", 0})}) {
    const Listener first(address);
    CHECK_THROWS_AS(Listener(first.address()), link::DeviceError);
    CHECK_THROWS_WITH(Listener(first.address()),
                      "cannot listen on " + link::name(first.address()) + ": another process listens there");
    const auto client = link::open(first.address());
    CHECK(first.accept());
  }
}

TEST_CASE("a file that is no socket is not touched") {
  const Scratch scratch;
  const std::string path = scratch.write("s", "text");
  CHECK_THROWS_WITH(Listener(link::UnixAddress{path}),
                    "cannot listen on unix:" + path + ": there is a file that is no socket");
  CHECK(test::contents(path) == "text");
}

TEST_CASE("a listener leaves a socket file alone that is not its own any more") {
  const Scratch scratch;
  auto first = std::make_unique<Listener>(link::UnixAddress{scratch / "s"});
  std::filesystem::remove(scratch / "s");
  const Listener second(link::UnixAddress{scratch / "s"});
  first.reset();
  CHECK_NOTHROW(link::open(second.address()));
}

TEST_CASE("a place where no client can connect is refused") {
  for (const char* address : {"mem:", "pipe:", "file:x"}) {
    CHECK_THROWS_AS(Listener(link::parse_address(address)), std::invalid_argument);
    CHECK_THROWS_WITH(Listener(link::parse_address(address)), "no client could connect to \"" +
                                                                  std::string(address) +
                                                                  "\"; use unix:PATH or tcp:HOST:PORT");
  }
  CHECK_THROWS_WITH(Listener(link::UnixAddress{"no-such-folder/s"}),
                    "cannot listen on unix:no-such-folder/s: No such file or directory");
}
