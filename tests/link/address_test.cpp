#include <halftone/link/link.h>

#include <catch2/catch.hpp>

#include <string>

using namespace halftone;
using namespace link;

TEST_CASE("an address is understood and named as it was written") {
  const auto is = [](const std::string& text, const Address& address) {
    INFO(text);
    CHECK(parse_address(text) == address);
    CHECK(name(address) == text);
  };
  is("mem:", MemoryAddress{});
  is("pipe:", PipeAddress{});
  is("file:a b:c", FileAddress{"a b:c"});
  is("unix:/run/m508", UnixAddress{"/run/m508"});
  is("tcp:localhost:8508", TcpAddress{"localhost", 8508});
  is("tcp:127.0.0.1:0", TcpAddress{"127.0.0.1", 0});
  is("tcp:[::1]:65535", TcpAddress{"::1", 65535});
  is("unix:" + std::string(107, 'x'), UnixAddress{std::string(107, 'x')});
}

TEST_CASE("without a host a TCP address is the loopback's") {
  CHECK(parse_address("tcp::8508") == Address(TcpAddress{"127.0.0.1", 8508}));
}

TEST_CASE("the addresses that have a way back are those that can answer") {
  for (const char* text : {"mem:", "unix:s", "tcp::1"}) CHECK(has_way_back(parse_address(text)));
  for (const char* text : {"file:s", "pipe:"}) CHECK_FALSE(has_way_back(parse_address(text)));
}

TEST_CASE("an address that is not understood is refused with advice") {
  const auto refused = [](const std::string& address, const std::string& problem) {
    CHECK_THROWS_AS(parse_address(address), std::invalid_argument);
    CHECK_THROWS_WITH(parse_address(address), "device address \"" + address + "\": " + problem);
    CHECK_THROWS_AS(open(address), std::invalid_argument);
  };
  const std::string forms = "not understood; use mem: (the device inside this program), file:PATH, pipe:, "
                            "unix:PATH or tcp:HOST:PORT";
  refused("", forms);
  refused("mem", forms);
  refused("http://localhost", forms);
  refused("mem:1", "nothing may follow \"mem:\"");
  refused("pipe:1", "nothing may follow \"pipe:\", which is standard output");
  refused("file:", "a path is needed, as in file:commands.bin");
  refused("unix:", "a path is needed, as in unix:m508.socket");
  refused("unix:" + std::string(108, 'x'), "the path has 108 bytes, a UNIX socket's at most 107; a path from "
                                           "the current folder is shorter");
  refused("tcp:", "expected tcp:HOST:PORT, as in tcp:127.0.0.1:8508");
  refused("tcp:8508", "expected tcp:HOST:PORT, as in tcp:127.0.0.1:8508");
  refused("tcp:::1:8508", "an IPv6 number needs brackets, as in tcp:[::1]:8508");
  for (const std::string port : {"", "65536", "-1", "99999999999", "http", "80x", " 80"})
    refused("tcp:h:" + port, "expected a port from 0 to 65535, found \"" + port + "\"");
}
