#include "client.h"

#include <halftone/serve/server.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace halftone;
using namespace std::chrono_literals;
using protocol::Message;
using protocol::Opcode;
using test::bytes_of;
using test::connect;
using test::places;
using test::Scratch;
using test::whole_read;
using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

namespace {

/// A server in this process.
class Server {
public:
  Server(const std::string& address, std::chrono::milliseconds patience)
      : listener_(link::parse_address(address)),
        thread_(
            [this, patience] { serve::serve(listener_, device_, {.patience = patience}, nullptr, stop_); }) {}
  ~Server() { stop(); }

  const link::Address& address() const { return listener_.address(); }

  void stop() {
    const std::uint64_t one = 1;
    if (thread_.joinable() && ::write(stop_.number(), &one, sizeof one) == sizeof one) thread_.join();
  }

private:
  file::Descriptor stop_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};
  serve::Listener listener_;
  device::Device device_;
  std::thread thread_;
};

/// The commands again and again, until the server takes no more of them, as it is waiting for its replies to
/// be taken. Returns how many bytes went.
std::size_t send_all_that_goes(const file::Descriptor& client, const Bytes& commands) {
  std::size_t total = 0;
  pollfd entry{client.number(), POLLOUT, 0};
  while (::poll(&entry, 1, 100) > 0) {
    const ssize_t count =
        ::send(client.number(), commands.data(), commands.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count <= 0) break;
    total += static_cast<std::size_t>(count);
  }
  return total;
}

std::uint32_t color_at_origin(const link::Address& address) {
  return test::color_at_origin(*link::open(address, 5s));
}

Message paint(std::uint32_t red) { return {Opcode::fill, 1, {0, 0, 512, 512, red, 0, 0}, {}}; }

} // namespace

TEST_CASE("a client that never takes its answers is cut off, its side ended or not, and the next is served") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    for (const bool ends_its_side : {true, false}) {
      INFO(place << ", ends its side: " << ends_its_side);
      const Server server(place, 100ms);
      const file::Descriptor client = connect(server.address());
      std::vector<Message> commands(100, whole_read);
      commands.insert(commands.begin(), paint(77));
      send_all_that_goes(client, bytes_of(commands));
      if (ends_its_side) ::shutdown(client.number(), SHUT_WR);
      CHECK(color_at_origin(server.address()) == 0x4D0000);
    }
  }
}

TEST_CASE("a client that takes its answers slowly, but takes them, gets all") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    const Server server(place, 400ms);
    const file::Descriptor client = connect(server.address());
    constexpr std::size_t answers = 30;
    const Bytes commands = bytes_of(std::vector<Message>(answers, whole_read));
    REQUIRE(::send(client.number(), commands.data(), commands.size(), 0) ==
            static_cast<ssize_t>(commands.size()));
    ::shutdown(client.number(), SHUT_WR);
    std::size_t total = 0, paused = 0;
    Bytes buffer(100'000);
    while (true) {
      if (total > paused * test::whole_read_answer) { // 600 ms of pauses in all
        ++paused;
        std::this_thread::sleep_for(20ms);
      }
      pollfd entry{client.number(), POLLIN, 0};
      REQUIRE(::poll(&entry, 1, 5000) == 1);
      const ssize_t count = ::recv(client.number(), buffer.data(), buffer.size(), 0);
      REQUIRE(count >= 0);
      if (count == 0) break;
      total += static_cast<std::size_t>(count);
    }
    CHECK(total == answers * test::whole_read_answer);
  }
}

TEST_CASE("what a client that has gone asked for is not answered to nobody") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    INFO(place);
    const Server server(place, 30s);
    file::Descriptor client = connect(server.address());
    const std::size_t sent = send_all_that_goes(client, bytes_of(std::vector<Message>(10'000, whole_read)));
    REQUIRE(sent > 100'000); // 3.7 GB of answers
    client.close();
    const auto start = Clock::now();
    CHECK(color_at_origin(server.address()) == 0);
    CHECK(Clock::now() - start < 2s);
  }
}

TEST_CASE("a server stops at once, however much a client that has gone left to be done") {
  const Scratch scratch;
  for (const std::string& place : places(scratch)) {
    INFO(place);
    Server server(place, 30s);
    file::Descriptor client = connect(server.address());
    // The first wait for their answers to be taken, and so the others for them.
    const Bytes first = bytes_of(std::vector<Message>(20, whole_read));
    REQUIRE(::send(client.number(), first.data(), first.size(), 0) == static_cast<ssize_t>(first.size()));
    const Message slow{Opcode::copy, 1, {0, 0, 511, 511, 1, 1, 0}, {}};
    const std::size_t sent = send_all_that_goes(client, bytes_of(std::vector<Message>(10'000, slow)));
    REQUIRE(sent > 100'000);
    client.close();
    const auto start = Clock::now();
    server.stop();
    CHECK(Clock::now() - start < 1s);
  }
}
