// Links without a way back: the driver sends, and asks nothing.

#include "picture.h"

#include <halftone/driver/driver.h>

#include <halftone/protocol/decoder.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace halftone;
using protocol::Message;
using protocol::Opcode;

namespace {

/// Keeps what is sent; may break after so many sends.
class OneWay final : public link::Link {
public:
  explicit OneWay(int sends = 1'000'000) : sends_(sends) {}

  void send(std::span<const std::uint8_t> bytes) override {
    if (sends_-- == 0) throw link::DeviceError("the disk is full");
    sent.insert(sent.end(), bytes.begin(), bytes.end());
  }
  std::size_t receive(std::span<std::uint8_t>, std::chrono::milliseconds) override {
    FAIL("asked on a link without a way back");
    return 0;
  }
  bool has_way_back() const override { return false; }

  std::vector<std::uint8_t> sent;

private:
  int sends_;
};

std::vector<Opcode> opcodes_of(std::span<const std::uint8_t> bytes) {
  protocol::Decoder decoder(protocol::Direction::to_device);
  std::vector<Opcode> opcodes;
  while (const auto item = decoder.next(bytes)) opcodes.push_back(std::get<Message>(item->content).opcode);
  return opcodes;
}

} // namespace

TEST_CASE("on a one-way link a picture is a reset, a window and its rows") {
  OneWay link;
  driver::Driver driver(link);
  test::send(driver, test::noise(20, 3, 1));
  driver.finish();
  CHECK(opcodes_of(link.sent) ==
        std::vector{Opcode::reset, Opcode::window, Opcode::pixels, Opcode::pixels, Opcode::pixels});
}

TEST_CASE("what goes one way draws the picture that was sent, in any order of the rows, also after finish") {
  OneWay link;
  driver::Driver driver(link);
  const auto picture = test::noise(20, 7, 2);
  driver.begin(20, 7);
  for (const int y : {3, 4, 5, 0, 1, 6}) driver.send_row(y, picture.row(y));
  driver.finish();
  driver.send_row(2, picture.row(2));
  driver.finish();

  const auto device = link::open("mem:");
  device->send(link.sent);
  std::vector<std::uint8_t> question;
  append(question, Message{Opcode::read, 1, {246, 252, 20, 7}, {}});
  device->send(question);
  std::vector<std::uint8_t> answer(10'000);
  answer.resize(device->receive(answer, std::chrono::seconds(1)));
  std::span<const std::uint8_t> rest = answer;
  protocol::Decoder decoder(protocol::Direction::to_host);
  std::vector<std::uint8_t> rgb;
  while (const auto item = decoder.next(rest)) {
    const auto row = std::get<Message>(item->content).data;
    rgb.insert(rgb.end(), row.begin(), row.end());
  }
  CHECK((rgb == picture.rgb));
}

TEST_CASE("a one-way link that breaks names the rows that may be missing") {
  OneWay at_once(0), later(5); // the reset, and four rows
  const auto picture = test::noise(20, 7, 3);
  driver::Driver first(at_once), second(later);
  CHECK_THROWS_WITH(test::send(first, picture), "the disk is full; no row of the picture was sent");
  CHECK_THROWS_WITH(test::send(second, picture),
                    "the disk is full; rows 0 to 6 of the picture may be missing");
}
