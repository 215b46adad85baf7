#include "peer.h"
#include "support/scratch.h"
#include "support/skip.h"

#include <halftone/link/link.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <future>
#include <random>
#include <thread>

#include <sys/resource.h>

using namespace halftone;
using namespace std::chrono_literals;
using test::Peer;
using test::read_from;
using test::write_to;

namespace {

std::string noise(std::size_t size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

std::span<const std::uint8_t> span_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

std::string receive(link::Link& link, std::size_t count) {
  std::string bytes;
  std::vector<std::uint8_t> buffer(1 << 16);
  while (bytes.size() < count) {
    const std::size_t got =
        link.receive(std::span(buffer).first(std::min(buffer.size(), count - bytes.size())), 5s);
    bytes.append(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(got));
  }
  return bytes;
}

/// Both kinds of socket, and both of IP.
struct Places {
  test::Scratch scratch;
  std::vector<link::Address> all{link::UnixAddress{scratch / "s"}, link::TcpAddress{"127.0.0.1", 0}};

  Places() {
    try { // machines without IPv6 there are
      Peer probe(link::TcpAddress{"::1", 0}, [](int) {});
      all.emplace_back(link::TcpAddress{"::1", 0});
    } catch (const std::exception&) {
      test::skip_anywhere("no IPv6 here");
    }
  }
};

double seconds_of(const std::function<void()>& task) {
  const auto start = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

TEST_CASE("bytes go both ways over every kind of socket, in pieces of any size") {
  const Places places;
  const std::string there = noise(5'000'000, 1), back = noise(3'000'000, 2);
  for (const link::Address& place : places.all) {
    std::string arrived;
    {
      Peer peer(place, [&](int connection) {
        arrived = read_from(connection, there.size());
        write_to(connection, back);
      });
      INFO(peer.address());
      const auto link = link::open(peer.address(), 5s);
      CHECK(link->has_way_back());
      std::mt19937_64 random(3);
      for (std::span<const std::uint8_t> rest = span_of(there); !rest.empty();) {
        const std::size_t piece = std::min<std::size_t>(rest.size(), random() % 100'000);
        link->send(rest.first(piece));
        rest = rest.subspan(piece);
      }
      CHECK((receive(*link, back.size()) == back));
    }
    CHECK((arrived == there));
  }
}

TEST_CASE("two sides that send at each other until all buffers are full do not wait for ever") {
  const Places places;
  const std::string much = noise(20'000'000, 4);
  for (const link::Address& place : places.all) {
    std::string arrived;
    {
      Peer peer(place, [&](int connection) { // answers before it reads
        write_to(connection, much);
        arrived = read_from(connection, much.size());
      });
      INFO(peer.address());
      const auto link = link::open(peer.address(), 5s);
      link->send(span_of(much));
      CHECK((receive(*link, much.size()) == much));
    }
    CHECK((arrived == much));
  }
}

TEST_CASE("a device that reads nothing, or says nothing, is a timeout in the time that was given") {
  const Places places;
  for (const link::Address& place : places.all) {
    std::promise<void> over;
    Peer peer(place, [done = over.get_future().share()](int) { done.wait(); });
    const auto link = link::open(peer.address(), 200ms);
    std::uint8_t byte = 0;
    CHECK(seconds_of([&] {
            CHECK_THROWS_WITH(link->receive({&byte, 1}, 100ms), "the device said nothing for 100 ms");
          }) < 2);
    const std::string much(50'000'000, 'x');
    CHECK(seconds_of([&] {
            CHECK_THROWS_WITH(link->send(span_of(much)), "the device took nothing for 200 ms");
            CHECK_THROWS_AS(link->send(span_of(much)), link::Timeout);
          }) < 4);
    over.set_value();
  }
}

TEST_CASE("a device that has gone is an error for who sends and who waits, and no signal") {
  const Places places;
  for (const link::Address& place : places.all) {
    Peer peer(place, [](int connection) { write_to(connection, "last"); });
    const auto link = link::open(peer.address(), 5s);
    CHECK(receive(*link, 4) == "last");
    std::uint8_t byte = 0;
    CHECK_THROWS_WITH(link->receive({&byte, 1}, 5s), "the device closed the connection");
    const std::string much(50'000'000, 'x');
    CHECK_THROWS_WITH(link->send(span_of(much)), "the device closed the connection");
  }
}

TEST_CASE("a device that sends without end is an error, not all of this machine's memory") {
  const test::Scratch scratch;
  Peer peer(link::UnixAddress{scratch / "s"}, [](int connection) {
    const std::string chatter(100'000, 'x');
    for (int i = 0; i < 1000; ++i) write_to(connection, chatter);
  });
  const auto link = link::open(peer.address(), 5s);
  const std::string much(50'000'000, 'x');
  CHECK_THROWS_WITH(link->send(span_of(much)), "the device sends without end, whatever it is asked");
}

TEST_CASE("where nobody listens, the error says how to start a device") {
  const test::Scratch scratch;
  const std::string nowhere = "unix:" + scratch / "none";
  CHECK_THROWS_AS(link::open(nowhere), link::DeviceError);
  CHECK_THROWS_WITH(link::open(nowhere), "no connection to " + nowhere +
                                             ": No such file or directory; a device is started with: m508 "
                                             "serve --listen " +
                                             nowhere);
  std::string closed;
  {
    const Peer peer(link::TcpAddress{"127.0.0.1", 0}, [](int) {});
    closed = peer.address();
  }
  CHECK_THROWS_WITH(link::open(closed), "no connection to " + closed +
                                            ": Connection refused; a device is started with: m508 serve "
                                            "--listen " +
                                            closed);
}

TEST_CASE("a host that does not exist is an error that names it") {
  CHECK_THROWS_AS(link::open("tcp:no-such-host.invalid:1"), link::DeviceError);
  CHECK_THROWS_WITH(link::open("tcp:no-such-host.invalid:1"),
                    Catch::StartsWith("no host \"no-such-host.invalid\" for tcp:no-such-host.invalid:1: "));
}

TEST_CASE("a socket that lets no more clients wait is a timeout") {
  const test::Scratch scratch;
  const link::SocketAddress at = link::resolve(link::UnixAddress{scratch / "s"});
  const file::Descriptor listener = link::open_socket(at);
  REQUIRE(::bind(listener.number(), at.get(), at.size) == 0);
  REQUIRE(::listen(listener.number(), 0) == 0);
  std::vector<std::unique_ptr<link::Link>> waiting;
  CHECK_THROWS_WITH(
      [&] {
        for (int i = 0; i < 10; ++i) waiting.push_back(link::open("unix:" + scratch / "s", 100ms));
      }(),
      "no connection to unix:" + scratch / "s" + " within 100 ms");
}

TEST_CASE("links give their descriptors back") {
  const test::Scratch scratch;
  const auto free_descriptor = [] {
    const int number = ::dup(0);
    ::close(number);
    return number;
  };
  const int before = free_descriptor();
  for (int i = 0; i < 20; ++i) {
    CHECK_THROWS(link::open("unix:" + scratch / "none"));
    CHECK_THROWS(link::open("tcp::1", 500ms));
    CHECK_THROWS(link::open("file:" + scratch / "none/f"));
    link::open("file:" + scratch / "f");
    const Peer peer(link::TcpAddress{"127.0.0.1", 0}, [](int) {});
    link::open(peer.address());
  }
  CHECK(free_descriptor() == before);
}

TEST_CASE("who waits for a device that does nothing is let go when the link is cut") {
  for (const bool is_sending : {false, true}) {
    const Places places;
    for (const link::Address& place : places.all) {
      std::promise<void> over;
      const Peer silent(place, [end = over.get_future().share()](int) { end.wait(); });
      const auto link = link::open(silent.address(), 20s);
      const double seconds = seconds_of([&] {
        const std::jthread cutter([&] {
          std::this_thread::sleep_for(100ms);
          link->cut();
        });
        std::vector<std::uint8_t> bytes(is_sending ? 64 << 20 : 1);
        if (is_sending)
          CHECK_THROWS_AS(link->send(bytes), link::DeviceError);
        else
          CHECK_THROWS_AS(link->receive(bytes, 20s), link::DeviceError);
      });
      CHECK(seconds < 5);
      CHECK_THROWS_AS(link->send(std::vector<std::uint8_t>(1)), link::DeviceError); // nor is it mended
      over.set_value();
    }
  }
}
