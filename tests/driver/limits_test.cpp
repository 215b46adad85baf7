#include "picture.h"

#include <halftone/driver/driver.h>

#include <halftone/protocol/decoder.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <thread>

// How long a driver tries, and what it says when it has to give up.

using namespace halftone;
using namespace std::chrono_literals;
using protocol::Message;
using protocol::Opcode;

namespace {

/// Before a device in memory; commands that `passes` does not let through are lost.
class Lossy final : public link::Link {
public:
  using Passes = std::function<bool(const Message& command)>;
  explicit Lossy(Passes passes) : passes_(std::move(passes)) {}

  void send(std::span<const std::uint8_t> bytes) override {
    while (const auto item = decoder_.next(bytes)) {
      const auto* command = std::get_if<Message>(&item->content);
      if (command == nullptr || !passes_(*command)) continue;
      std::vector<std::uint8_t> again;
      append(again, *command);
      device_->send(again);
    }
  }

  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    try {
      return device_->receive(bytes, timeout);
    } catch (
        const link::Timeout&) { // at once, since nothing can come any more: a device elsewhere has one wait
      std::this_thread::sleep_for(timeout);
      throw;
    }
  }

private:
  Passes passes_;
  protocol::Decoder decoder_{protocol::Direction::to_device};
  std::unique_ptr<link::Link> device_ = link::open("mem:");
};

bool is_query(const Message& command) { return protocol::entry_of(command.opcode).answer.has_value(); }

} // namespace

TEST_CASE(
    "a link over which everything has to be said again and again is given up in ten times the timeout") {
  std::map<std::uint32_t, int> asked;
  Lossy link([&](const Message& command) {
    if (!is_query(command)) return command.opcode != Opcode::pixels;
    return ++asked[command.sequence] == 4;
  });
  driver::Driver driver(link, 20ms); // some 5 ms a question, of which there are thousands
  test::send(driver, test::noise(512, 512, 1));
  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_WITH(driver.finish(),
                    "the link is too bad: questions and repeats took longer than 200 ms; rows 0 "
                    "to 511 of the picture may be missing");
  CHECK(std::chrono::steady_clock::now() - start < 2s);
}

TEST_CASE("what was verified before a repair is not taken for held after it") {
  int rows = 0, sums = 0;
  Lossy link([&](const Message& command) {
    if (command.opcode == Opcode::pixels) return ++rows != 6;
    const bool is_round = command.opcode == Opcode::checksum && command.operands[3] == 512;
    if (is_round && ++sums == 2) throw link::DeviceError("the device has gone");
    return true;
  });
  driver::Driver driver(link, 200ms);
  test::send(driver, test::noise(10, 10, 1));
  CHECK_THROWS_WITH(driver.finish(), "the device has gone; rows 0 to 9 of the picture may be missing");
  CHECK(rows == 15); // what came after the lost row went one row too high
}
