#include <halftone/device/device.h>

#include <halftone/protocol/checksum.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <string>

using namespace halftone;
using protocol::Message;
using protocol::Opcode;
using Bytes = std::vector<std::uint8_t>;
using Pixel = std::array<int, 3>;

namespace {

/// A device that is spoken to with bytes, and what it says as messages.
struct Bench {
  device::Device device;
  protocol::Decoder to_device{protocol::Direction::to_device};
  protocol::Decoder to_host{protocol::Direction::to_host};
  Bytes replies;

  void receive(std::span<const std::uint8_t> bytes) {
    while (const auto item = to_device.next(bytes)) device.execute(*item, replies);
  }

  void command(Opcode opcode, std::array<std::uint32_t, protocol::operand_limit> operands,
               const Bytes& data = {}) {
    Bytes bytes;
    append(bytes, Message{opcode, ++sequence, operands, data});
    receive(bytes);
  }

  /// The one reply to a query.
  Message query(Opcode opcode, std::array<std::uint32_t, protocol::operand_limit> operands = {}) {
    replies.clear();
    command(opcode, operands);
    std::span<const std::uint8_t> bytes = replies;
    const auto item = to_host.next(bytes);
    REQUIRE(item);
    REQUIRE(bytes.empty());
    const auto reply = std::get<Message>(item->content);
    CHECK(reply.sequence == sequence);
    return reply;
  }

  Pixel pixel(std::size_t x, std::size_t y) const {
    const std::size_t i = (y * 512 + x) * 3;
    return {device.image[i], device.image[i + 1], device.image[i + 2]};
  }

  std::uint32_t sequence = 0;
};

/// Pixels of grey levels from `first` on.
Bytes greys(int first, int count) {
  Bytes data;
  for (int i = first; i < first + count; ++i) data.insert(data.end(), 3, static_cast<std::uint8_t>(i));
  return data;
}

Pixel grey(int level) { return {level, level, level}; }

} // namespace

TEST_CASE("the device says what it is") {
  Bench bench;
  const Message identity = bench.query(Opcode::identify);
  CHECK(identity.operands[0] == 0);
  CHECK(identity.operands[1] == protocol::protocol_version);
  CHECK(identity.operands[2] == 512);
  CHECK(identity.operands[3] == 512);
  CHECK(std::string(identity.data.begin(), identity.data.end()) == "M508R, reconstructed");
}

TEST_CASE("pixels fill the window in row order, in pieces of any size, and wrap at its end") {
  for (const int piece : {1, 2, 3, 5, 6, 13}) {
    Bench bench;
    bench.command(Opcode::window, {510, 7, 2, 3});
    for (int first = 1; first <= 8;) {
      const int count = std::min(piece, 9 - first);
      bench.command(Opcode::pixels, {}, greys(first, count));
      first += count;
    }
    INFO("pieces of " << piece);
    CHECK(bench.pixel(510, 7) == grey(7)); // the seventh wrapped
    CHECK(bench.pixel(511, 7) == grey(8));
    CHECK(bench.pixel(510, 8) == grey(3));
    CHECK(bench.pixel(511, 8) == grey(4));
    CHECK(bench.pixel(510, 9) == grey(5));
    CHECK(bench.pixel(511, 9) == grey(6));
    CHECK(std::ranges::count_if(bench.device.image, [](int byte) { return byte != 0; }) == 18);
    CHECK(bench.device.registers.x == 510);
    CHECK(bench.device.registers.y == 8);
  }
}

TEST_CASE("setting the window again brings the writing position to its top left") {
  Bench bench;
  bench.command(Opcode::window, {0, 0, 4, 4});
  bench.command(Opcode::pixels, {}, greys(1, 5));
  bench.command(Opcode::window, {0, 0, 4, 4});
  bench.command(Opcode::pixels, {}, greys(100, 1));
  CHECK(bench.pixel(0, 0) == grey(100));
  CHECK(bench.pixel(1, 0) == grey(2));
}

TEST_CASE("fill reaches to the rectangle's edges and not beyond, and leaves the window alone") {
  Bench bench;
  bench.command(Opcode::window, {100, 100, 2, 2});
  bench.command(Opcode::fill, {10, 20, 3, 2, 1, 2, 3});
  for (std::size_t y = 18; y < 24; ++y) {
    for (std::size_t x = 8; x < 16; ++x) {
      INFO(x << ", " << y);
      const bool inside = x >= 10 && x < 13 && y >= 20 && y < 22;
      CHECK(bench.pixel(x, y) == (inside ? Pixel{1, 2, 3} : Pixel{0, 0, 0}));
    }
  }
  bench.command(Opcode::pixels, {}, greys(9, 1));
  CHECK(bench.pixel(100, 100) == grey(9));
}

TEST_CASE("clear blackens the image and keeps the window and the writing position") {
  Bench bench;
  bench.command(Opcode::fill, {0, 0, 512, 512, 255, 255, 255});
  bench.command(Opcode::window, {5, 6, 7, 8});
  bench.command(Opcode::pixels, {}, greys(1, 1));
  bench.command(Opcode::clear, {});
  CHECK(std::ranges::count(bench.device.image, 0) == 512 * 512 * 3);
  CHECK(bench.device.registers.window == device::Rectangle{5, 6, 7, 8});
  CHECK(bench.device.registers.x == 6);
}

TEST_CASE("reset brings back the state at power-on") {
  Bench bench;
  bench.command(Opcode::window, {5, 6, 7, 8});
  bench.command(Opcode::pixels, {}, greys(1, 1));
  bench.receive(Bytes{'j', 'u', 'n', 'k'});
  bench.query(Opcode::status);
  CHECK((bench.device != device::Device{}));
  bench.command(Opcode::reset, {});
  CHECK((bench.device == device::Device{}));
}

TEST_CASE("read answers a row at a time, from the top") {
  Bench bench;
  bench.command(Opcode::window, {3, 4, 2, 2});
  bench.command(Opcode::pixels, {}, greys(1, 4));
  bench.command(Opcode::read, {3, 4, 2, 2});
  std::span<const std::uint8_t> bytes = bench.replies;
  for (const std::uint32_t row : {0U, 1U}) {
    const auto item = bench.to_host.next(bytes);
    REQUIRE(item);
    const auto& reply = std::get<Message>(item->content);
    CHECK(reply.opcode == Opcode::row);
    CHECK(reply.operands[0] == 3);
    CHECK(reply.operands[1] == 4 + row);
    CHECK(std::ranges::equal(reply.data, greys(1 + 2 * static_cast<int>(row), 2)));
  }
  CHECK(bytes.empty());
}

TEST_CASE("the checksum of a rectangle is that of its bytes in row order") {
  Bench bench;
  CHECK(bench.query(Opcode::checksum, {0, 0, 512, 512}).operands[0] ==
        protocol::checksum(Bytes(512 * 512 * 3)));
  bench.command(Opcode::window, {3, 4, 2, 2});
  bench.command(Opcode::pixels, {}, greys(1, 4));
  CHECK(bench.query(Opcode::checksum, {3, 4, 2, 2}).operands[0] == protocol::checksum(greys(1, 4)));
}

TEST_CASE("status tells the first error and counts errors, commands and damaged bytes") {
  Bench bench;
  bench.command(Opcode::window, {0, 0, 1, 1});
  bench.query(Opcode::status);
  Bytes unknown;
  append(unknown, protocol::Frame{0x7F, 42, {}});
  bench.receive(unknown);
  bench.receive(Bytes{'j', 'u', 'n', 'k'});
  bench.command(Opcode::clear, {});
  const Message state = bench.query(Opcode::status);
  CHECK(state.operands[0] == static_cast<std::uint32_t>(protocol::Fault::unknown_opcode));
  CHECK(state.operands[1] == 42);
  CHECK(state.operands[2] == 2);
  CHECK(state.operands[3] == 2);
  CHECK(state.operands[4] == 4);
}
