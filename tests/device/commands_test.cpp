#include <halftone/device/device.h>
#include <halftone/device/screen.h>

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

  Pixel pixel(std::size_t x, std::size_t y, std::size_t buffer = 0) const {
    const std::size_t i = (y * 512 + x) * 3;
    const Bytes& image = device.images[buffer];
    return {image[i], image[i + 1], image[i + 2]};
  }

  Pixel shown(std::size_t x, std::size_t y) const {
    std::array<std::uint8_t, std::size_t{512} * 3> row;
    device::scan_out(device, static_cast<std::uint32_t>(y), row);
    return {row[x * 3], row[x * 3 + 1], row[x * 3 + 2]};
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
    CHECK(std::ranges::count_if(bench.device.images[0], [](int byte) { return byte != 0; }) == 18);
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
  CHECK(std::ranges::count(bench.device.images[0], 0) == 512 * 512 * 3);
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
  bench.device.clock = {}; // it runs on
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

TEST_CASE("runs and repeated pixels go on where pixels end, and wrap as they do") {
  Bench bench;
  bench.command(Opcode::window, {10, 10, 4, 2});
  bench.command(Opcode::pixels, {}, greys(1, 1));
  bench.command(Opcode::runs, {}, {1, 5, 5, 5, 0, 6, 6, 6}); // two of grey 5, one of 6
  bench.command(Opcode::repeat, {5, 7, 7, 7});
  CHECK(bench.pixel(10, 10) == grey(7)); // the ninth
  CHECK(bench.pixel(11, 10) == grey(5));
  CHECK(bench.pixel(12, 10) == grey(5));
  CHECK(bench.pixel(13, 10) == grey(6));
  for (const std::size_t x : {10, 11, 12, 13}) CHECK(bench.pixel(x, 11) == grey(7));
}

TEST_CASE("the write mask lets through the bits that it has set, and clear does not ask it") {
  Bench bench;
  bench.command(Opcode::fill, {0, 0, 4, 1, 0xAA, 0xAA, 0xAA});
  bench.command(Opcode::write_mask, {0x0F, 0xF0, 0x00});
  bench.command(Opcode::window, {0, 0, 4, 1});
  bench.command(Opcode::pixels, {}, {0x55, 0x55, 0x55});
  CHECK(bench.pixel(0, 0) == Pixel{0xA5, 0x5A, 0xAA});
  bench.command(Opcode::repeat, {1, 0x55, 0x55, 0x55});
  CHECK(bench.pixel(1, 0) == Pixel{0xA5, 0x5A, 0xAA});
  bench.command(Opcode::fill, {2, 0, 1, 1, 0x55, 0x55, 0x55});
  CHECK(bench.pixel(2, 0) == Pixel{0xA5, 0x5A, 0xAA});
  bench.command(Opcode::clear, {});
  CHECK(bench.pixel(0, 0) == grey(0));
}

TEST_CASE("a copy of a rectangle onto itself is that of what was there before") {
  for (const std::uint32_t to_x : {9U, 11U}) {
    Bench bench;
    bench.command(Opcode::window, {10, 0, 8, 1});
    bench.command(Opcode::pixels, {}, greys(1, 8));
    bench.command(Opcode::copy, {10, 0, 8, 1, to_x, 0, 0});
    INFO("to column " << to_x);
    for (std::size_t i = 0; i < 8; ++i) CHECK(bench.pixel(to_x + i, 0) == grey(static_cast<int>(i + 1)));
  }
}

TEST_CASE("one image is shown while the other is written") {
  Bench bench;
  bench.command(Opcode::buffers, {1, 0});
  bench.command(Opcode::fill, {0, 0, 8, 8, 9, 9, 9});
  CHECK(bench.pixel(0, 0, 1) == grey(9));
  CHECK(bench.shown(0, 0) == grey(0));
  bench.command(Opcode::buffers, {0, 1});
  CHECK(bench.shown(0, 0) == grey(9));
  bench.command(Opcode::copy, {0, 0, 8, 8, 100, 100, 1});
  CHECK(bench.pixel(100, 100, 0) == grey(9));
}

TEST_CASE("the image goes through pan, zoom, read mask and look-up tables, in this order") {
  Bench bench;
  bench.command(Opcode::fill, {511, 511, 1, 1, 0x81, 0x42, 0x24});
  bench.command(Opcode::pan, {510, 511});
  CHECK(bench.shown(1, 0) == Pixel{0x81, 0x42, 0x24});
  bench.command(Opcode::zoom, {2});
  for (const std::size_t x : {4, 7}) CHECK(bench.shown(x, 3) == Pixel{0x81, 0x42, 0x24});
  CHECK(bench.shown(8, 0) == grey(0)); // column 0 of the image, around the edge
  CHECK(bench.shown(4, 4) == grey(0));
  bench.command(Opcode::read_mask, {0x0F, 0xFF, 0xF0});
  CHECK(bench.shown(4, 0) == Pixel{0x01, 0x42, 0x20});
  bench.command(Opcode::lut, {1 + 4, 0x01}, {77});
  CHECK(bench.shown(4, 0) == Pixel{77, 0x42, 0x20});
}

TEST_CASE("a ramp is a straight line, up or down, and meets both of its ends") {
  Bench bench;
  bench.command(Opcode::ramp, {1, 0, 256, 255, 0});
  bench.command(Opcode::ramp, {2, 10, 5, 0, 255});
  bench.command(Opcode::ramp, {4, 0, 3, 5, 0});
  for (std::size_t i = 0; i < 256; ++i) CHECK(bench.device.luts[0][i] == 255 - i);
  const std::array green{0, 64, 128, 191, 255}; // 63.75, 127.5, 191.25
  for (std::size_t i = 0; i < 5; ++i) CHECK(bench.device.luts[1][10 + i] == green[i]);
  CHECK(bench.device.luts[1][9] == 9);
  CHECK(bench.device.luts[1][15] == 15);
  CHECK(bench.device.luts[2][1] == 2); // 2.5, away from 5
}

TEST_CASE("border covers cursor, cursor covers overlay, overlay covers the image, and blank all") {
  Bench bench;
  bench.command(Opcode::cursor_pattern, {}, Bytes(32, 0xFF));
  bench.command(Opcode::fill, {0, 0, 512, 512, 1, 1, 1});
  bench.command(Opcode::overlay_fill, {0, 0, 32, 32, 1});
  bench.command(Opcode::overlay_bits, {0, 5}, {0x7F}); // 0 at (0, 5)
  bench.command(Opcode::overlay, {1, 0, 2, 2, 2});
  bench.command(Opcode::cursor, {4, 4, 1, 0, 3, 3, 3});
  CHECK(bench.shown(40, 40) == grey(1));
  CHECK(bench.shown(0, 0) == grey(2));
  CHECK(bench.shown(0, 5) == grey(1));
  CHECK(bench.shown(4, 4) == grey(3));
  CHECK(bench.shown(19, 19) == grey(3));
  CHECK(bench.shown(20, 19) == grey(2));
  bench.command(Opcode::border, {5, 4, 4, 4});
  CHECK(bench.shown(4, 100) == grey(4));
  CHECK(bench.shown(507, 100) == grey(4));
  CHECK(bench.shown(506, 100) == grey(1));
  CHECK(bench.shown(5, 5) == grey(3));
  bench.command(Opcode::blank, {1});
  CHECK(bench.shown(100, 100) == grey(0));
  bench.command(Opcode::blank, {0});
  CHECK(bench.shown(100, 100) == grey(1));
}

TEST_CASE("what blinks is shown for so many fields, and then not for as many") {
  Bench bench;
  bench.command(Opcode::overlay_fill, {0, 0, 1, 1, 1});
  bench.command(Opcode::overlay, {1, 3, 9, 9, 9});
  for (int field = 0; field < 12; ++field) {
    INFO("field " << field);
    CHECK(bench.shown(0, 0) == grey(field / 3 % 2 == 0 ? 9 : 0));
    bench.command(Opcode::wait, {1});
  }
}

TEST_CASE("the clock counts the bytes on the bus and the device's own time, and a wait ends with a field") {
  Bench bench;
  bench.device.clock.bus = {"19,200 baud", 520'833'333, 0};
  bench.command(Opcode::window, {0, 0, 2, 1});
  CHECK(bench.device.clock.picoseconds == 21 * 520'833'333ULL + 10'000'000);
  bench.command(Opcode::wait, {60});
  CHECK(bench.query(Opcode::status).operands[5] == 61); // 22 ms were more than a field
  CHECK(device::fields(bench.device.clock) == 61);

  device::Clock clock;
  for (std::uint32_t field = 1; field < 200; ++field) {
    clock.wait(1);
    CHECK(device::fields(clock) == field);
    device::Clock before = clock;
    before.picoseconds -= 1;
    CHECK(device::fields(before) == field - 1);
  }
}
