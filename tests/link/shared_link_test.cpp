#include "peer.h"

#include "support/comes_true.h"
#include "support/scratch.h"

#include <halftone/file/write.h>
#include <halftone/link/shared_link.h>

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

/// More than any socket holds for a device that does not read.
constexpr std::size_t large = 8'000'000;

std::vector<std::uint8_t> message_of(std::size_t size, char letter) {
  return std::vector<std::uint8_t>(size, static_cast<std::uint8_t>(letter));
}

/// A device that takes nothing until it is told to, and then so much.
struct Stalled {
  test::Scratch scratch;
  std::promise<std::size_t> goes_on;
  std::promise<std::string> arrived;
  test::Peer peer{link::UnixAddress{scratch / "s"},
                  [this, count = goes_on.get_future().share()](int connection) {
                    arrived.set_value(test::read_from(connection, count.get()));
                  }};
  link::SharedLink link{link::open(peer.address(), 60s)};
};

/// A link that fails with whatever is sent.
template<typename Error>
struct Failing final : link::Link {
  void send(std::span<const std::uint8_t>) override { throw Error("it failed"); }
  std::size_t receive(std::span<std::uint8_t>, std::chrono::milliseconds) override { return 0; }
};

template<typename Error>
bool is_told(const link::SharedLink& link) {
  try {
    link.check();
    return false;
  } catch (const Error&) {
    return true;
  }
}

template<typename Error>
void require_told() {
  for (const bool is_cut : {false, true}) {
    CAPTURE(is_cut);
    link::SharedLink link(std::make_unique<Failing<Error>>());
    link.post(message_of(1, 'a'));
    CHECK(test::comes_true([&] { return is_told<Error>(link); }));
    if (is_cut) link.cut();
    CHECK_THROWS_AS(link.post(message_of(1, 'b')), Error);
    CHECK_THROWS_AS(link.settle(10s), Error);
    CHECK_THROWS_AS(link.check(), Error);
  }
}

/// A device that takes a while to take something, and never has anything to say.
struct Slow final : link::Link {
  void send(std::span<const std::uint8_t> bytes) override {
    std::this_thread::sleep_for(2ms);
    taken += bytes.size();
  }
  std::size_t receive(std::span<std::uint8_t>, std::chrono::milliseconds) override {
    ++looks;
    std::this_thread::sleep_for(1ms);
    throw link::Timeout("nothing came");
  }

  std::atomic<std::size_t> taken = 0, looks = 0;
};

} // namespace

TEST_CASE("who posts does not wait for a device that stalls and nothing is lost or torn") {
  Stalled stalled;
  std::jthread sender([&] {
    for (int i = 0; i < 2; ++i) stalled.link.send(message_of(large, 'm'));
  });
  std::this_thread::sleep_for(100ms); // in the midst of the first
  const auto start = Clock::now();
  for (char key = 'a'; key < 'm'; ++key) stalled.link.post(message_of(2, key));
  CHECK(Clock::now() - start < 2s);
  stalled.goes_on.set_value(2 * large + 24);
  sender.join();
  stalled.link.settle(10s);
  std::string arrived = stalled.arrived.get_future().get();
  // Whole messages, between which the posted ones stand in their order.
  std::string posted;
  for (std::size_t place = 0; place < arrived.size();) {
    if (arrived[place] == 'm') {
      REQUIRE(arrived.compare(place, large, std::string(large, 'm')) == 0);
      place += large;
    } else {
      posted += arrived[place++];
    }
  }
  CHECK(posted == "aabbccddeeffgghhiijjkkll");
}

TEST_CASE("a device that listens has what was posted before the next key") {
  auto over = std::make_unique<Slow>();
  const Slow& device = *over;
  link::SharedLink link(std::move(over));
  constexpr std::size_t keys = 40;
  std::size_t waited = 0;
  for (std::size_t key = 1; key <= keys; ++key) {
    link.post(message_of(1, 'a'));
    waited += device.taken == key;
    REQUIRE(test::comes_true([&] { return device.taken == key; }));
  }
  CHECK(waited > keys / 2); // a machine that does other things may take longer than a moment for some
}

TEST_CASE("who posts does not stand behind who receives again and again") {
  auto over = std::make_unique<Slow>();
  const Slow& device = *over;
  link::SharedLink link(std::move(over));
  std::jthread receiver([&](const std::stop_token& end) {
    std::array<std::uint8_t, 8> bytes{};
    while (!end.stop_requested()) {
      try {
        link.receive(bytes, 100ms);
      } catch (const link::Timeout&) { // as each of them is
      }
    }
  });
  REQUIRE(test::comes_true([&] { return device.looks > 0; }));
  std::size_t late = 0;
  for (std::size_t key = 1; key <= 300; ++key) {
    const std::size_t before = device.looks;
    link.post(message_of(1, 'a'));
    REQUIRE(test::comes_true([&] { return device.taken == key; }));
    late += device.looks - before > 1;
  }
  CHECK(late < 100); // of a mutex alone, most of them
}

TEST_CASE("what fails of what is posted is told") {
  require_told<link::DeviceError>();
  require_told<link::Timeout>();
  require_told<file::WriteError>();
}

TEST_CASE("the end does not wait for a device that takes nothing and is no failure") {
  for (const bool is_cut : {false, true}) {
    CAPTURE(is_cut);
    Stalled stalled;
    const auto start = Clock::now();
    stalled.link.post(message_of(large, 'm'));
    stalled.link.post(message_of(1, 'a'));
    if (is_cut) stalled.link.cut();
    CHECK_NOTHROW(stalled.link.settle(200ms));
    CHECK(Clock::now() - start < 5s);
    CHECK_THROWS_AS(stalled.link.send(message_of(1, 'b')), link::DeviceError);
    stalled.goes_on.set_value(0);
  }
}
