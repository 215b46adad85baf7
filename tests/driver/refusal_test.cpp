#include "picture.h"

#include <halftone/driver/driver.h>

#include <halftone/protocol/decoder.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

// Devices that do not do what they should, and what the driver says of them.

using namespace halftone;
using namespace std::chrono_literals;
using protocol::Message;
using protocol::Opcode;

namespace {

/// Between host and a device in memory; whatever the device replies may be changed.
class ChangedReplies final : public link::Link {
public:
  using Change = std::function<std::vector<Message>(Message reply)>;
  explicit ChangedReplies(Change change) : change_(std::move(change)) {}

  void send(std::span<const std::uint8_t> bytes) override { device_->send(bytes); }

  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    while (waiting_.empty()) {
      std::vector<std::uint8_t> piece(1000);
      std::span<const std::uint8_t> received = std::span(piece).first(device_->receive(piece, timeout));
      while (const auto item = decoder_.next(received)) {
        for (const Message& reply : change_(std::get<Message>(item->content))) append(waiting_, reply);
      }
    }
    const std::size_t count = std::min(bytes.size(), waiting_.size());
    std::copy_n(waiting_.begin(), count, bytes.begin());
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

private:
  Change change_;
  std::vector<std::uint8_t> waiting_;
  protocol::Decoder decoder_{protocol::Direction::to_host};
  std::unique_ptr<link::Link> device_ = link::open("mem:");
};

ChangedReplies with_operand(Opcode opcode, std::size_t index, std::uint32_t value) {
  return ChangedReplies([=](Message reply) {
    if (reply.opcode == opcode) reply.operands[index] = value;
    return std::vector{reply};
  });
}

/// Takes everything and answers with nothing, or with what never is an answer.
class Chatterer final : public link::Link {
public:
  explicit Chatterer(std::vector<std::uint8_t> chatter) : chatter_(std::move(chatter)) {}
  void send(std::span<const std::uint8_t>) override {}
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    if (chatter_.empty()) {
      std::this_thread::sleep_for(timeout);
      throw link::Timeout("silence");
    }
    std::ranges::copy(chatter_, bytes.begin());
    return chatter_.size();
  }

private:
  std::vector<std::uint8_t> chatter_;
};

/// A device whose memory is broken in rows 300, 301 and 303: no checksum over them is ever right.
class Broken final : public link::Link {
public:
  void send(std::span<const std::uint8_t> bytes) override {
    std::span<const std::uint8_t> rest = bytes;
    while (const auto item = decoder_.next(rest)) {
      const auto& command = std::get<Message>(item->content);
      std::vector<std::uint8_t> again;
      append(again, command);
      if (command.opcode == Opcode::checksum) {
        const std::uint32_t first = command.operands[1], end = first + command.operands[3];
        const auto covers = [&](std::uint32_t row) { return first <= row && row < end; };
        wrong_ = covers(300) || covers(301) || covers(303);
      }
      device_->send(again);
    }
  }
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    std::vector<std::uint8_t> piece(100);
    std::span<const std::uint8_t> received = std::span(piece).first(device_->receive(piece, timeout));
    std::vector<std::uint8_t> replies;
    protocol::Decoder decoder(protocol::Direction::to_host);
    while (const auto item = decoder.next(received)) {
      Message reply = std::get<Message>(item->content);
      if (reply.opcode == Opcode::sum && wrong_) reply.operands[0] = ~reply.operands[0];
      append(replies, reply);
    }
    std::ranges::copy(replies, bytes.begin());
    return replies.size();
  }

private:
  protocol::Decoder decoder_{protocol::Direction::to_device};
  bool wrong_ = false;
  std::unique_ptr<link::Link> device_ = link::open("mem:");
};

void send_and_finish(link::Link& link) {
  driver::Driver driver(link, 200ms);
  test::send(driver, test::noise(10, 10, 1));
  driver.finish();
}

} // namespace

TEST_CASE("a device that is another one is refused by name of what differs") {
  using protocol::index_of;
  const auto refused = [](std::size_t index, const std::string& message) {
    auto link = with_operand(Opcode::identity, index, 9);
    CHECK_THROWS_WITH(send_and_finish(link), message);
  };
  refused(index_of(Opcode::identity, "profile"), "the device has command set 9 where this program needs 0");
  refused(index_of(Opcode::identity, "version"),
          "the device has protocol version 9 where this program needs 1");
  refused(index_of(Opcode::identity, "width"), "the device has screen width 9 where this program needs 512");
  refused(index_of(Opcode::identity, "height"),
          "the device has screen height 9 where this program needs 512");
}

TEST_CASE("a device that does not take the reset is an error") {
  auto link = with_operand(Opcode::state, protocol::index_of(Opcode::state, "commands"), 700);
  CHECK_THROWS_WITH(send_and_finish(link), "the device did not take a reset, sent 16 times");
}

TEST_CASE("a command that the device refuses is named with its reason") {
  ChangedReplies link([](Message reply) {
    if (reply.opcode == Opcode::state) {
      reply.operands[0] = static_cast<std::uint32_t>(protocol::Fault::out_of_limits);
      reply.operands[1] = 12;
    }
    return std::vector{reply};
  });
  CHECK_THROWS_AS(send_and_finish(link), link::DeviceError);
  CHECK_THROWS_WITH(send_and_finish(link), "the device refused command 12: out of limits");
}

TEST_CASE("rows that the device does not hold are named") {
  Broken link;
  CHECK_THROWS_WITH(send_and_finish(link),
                    "the device does not hold what was sent to it: rows 300 to 301, 303 of the "
                    "screen differ after 16 repeats");
}

TEST_CASE("a device that does not answer is a timeout, in the time that was given") {
  Chatterer silent({});
  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_WITH(send_and_finish(silent),
                    "the device did not answer \"identify\" within 200 ms; no row of the picture was sent");
  const auto time = std::chrono::steady_clock::now() - start;
  CHECK(time > 150ms);
  CHECK(time < 2s);
}

TEST_CASE("a device that talks and never answers is a timeout as well") {
  std::vector<std::uint8_t> late_answer;
  append(late_answer, Message{Opcode::sum, 12345, {1}, {}});
  for (const auto& chatter :
       {std::vector<std::uint8_t>(100, 0), std::vector<std::uint8_t>(100, 'M'), late_answer}) {
    Chatterer link(chatter);
    const auto start = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(send_and_finish(link), link::Timeout);
    CHECK(std::chrono::steady_clock::now() - start < 2s);
  }
}

TEST_CASE("answers that come twice, or late, do no harm") {
  ChangedReplies link([](const Message& reply) {
    const Message late{Opcode::sum, reply.sequence - 1, {0x12345678}, {}};
    return std::vector{late, reply, reply};
  });
  driver::Driver driver(link, 200ms);
  const auto picture = test::noise(30, 70, 1);
  test::send(driver, picture);
  driver.finish();
  CHECK((driver.read_picture() == picture.rgb));
}

TEST_CASE("a device that gives back other rows than were sent is an error that names them") {
  const std::vector<std::uint8_t> black(512 * 3);
  ChangedReplies link([&](const Message& reply) {
    Message changed = reply;
    const std::uint32_t y = reply.operands[protocol::index_of(Opcode::row, "y")];
    if (reply.opcode == Opcode::row && (y == 252 || y == 253))
      changed.data = std::span(black).first(reply.data.size());
    return std::vector{changed};
  });
  driver::Driver driver(link, 200ms);
  test::send(driver, test::noise(10, 10, 1));
  driver.finish();
  const std::string message = "the device does not give back what was sent to it: rows 252 to 253 of the "
                              "screen differ, read 4 times";
  CHECK_THROWS_WITH(driver.read_picture(), message);
  CHECK_THROWS_WITH(driver.read_screen(), message);
}

TEST_CASE("a device that falls silent while it is read names the rows that were not read back") {
  bool silent = false;
  ChangedReplies link([&](const Message& reply) {
    const bool last = reply.opcode == Opcode::row && reply.operands[1] >= 256;
    silent = silent || last;
    return silent ? std::vector<Message>{} : std::vector{reply};
  });
  driver::Driver driver(link, 200ms);
  test::send(driver, test::noise(10, 10, 1));
  driver.finish();
  CHECK_THROWS_WITH(driver.read_picture(),
                    "the device did not answer \"read\" within 200 ms; rows 5 to 9 were not read back");
}
