#include "naive_codec.h"
#include "random_message.h"

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace halftone::protocol;
using halftone::test::Bytes;

namespace {

Frame frame_of(const Bytes& bytes) {
  return {bytes[2],
          static_cast<std::uint32_t>(bytes[3]) << 24 | static_cast<std::uint32_t>(bytes[4]) << 16 |
              static_cast<std::uint32_t>(bytes[5]) << 8 | bytes[6],
          std::span(bytes).subspan(header_size, bytes.size() - header_size - checksum_size)};
}

/// The bytes of a payload, without regard to limits.
Bytes payload_of(const OpcodeEntry& entry, const Message& message) {
  Bytes payload;
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    for (std::size_t byte = size_of(entry.operands[i].type); byte-- > 0;) {
      payload.push_back(static_cast<std::uint8_t>(message.operands[i] >> 8 * byte));
    }
  }
  payload.insert(payload.end(), message.data.begin(), message.data.end());
  return payload;
}

Fault fault_of(const OpcodeEntry& entry, const Bytes& payload) {
  const auto parsed = parse({static_cast<std::uint8_t>(entry.opcode), 7, payload}, entry.direction);
  const auto* rejection = std::get_if<Rejection>(&parsed);
  if (rejection == nullptr) return Fault::none;
  CHECK(rejection->sequence == 7);
  CHECK(rejection->opcode == static_cast<std::uint8_t>(entry.opcode));
  return rejection->fault;
}

} // namespace

TEST_CASE("the checksum is that of zlib, PNG and Ethernet") {
  const Bytes check{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  CHECK(checksum(check) == 0xCBF43926); // the published check value of CRC-32
  CHECK(checksum(std::span(check).subspan(4), checksum(std::span(check).first(4))) == 0xCBF43926);
  CHECK(checksum({}) == 0);
  CHECK(checksum({}, 0x1234) == 0x1234);
}

TEST_CASE("what is encoded is decoded as it was, for every opcode") {
  halftone::test::Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const OpcodeEntry& entry = opcode_table[static_cast<std::size_t>(i) % opcode_table.size()];
    const auto sent = halftone::test::random_message(random, entry);
    Bytes bytes;
    append(bytes, sent.message);
    INFO("seed 1, message " << i << ", " << entry.name);
    REQUIRE(bytes == halftone::test::naive_frame(static_cast<std::uint8_t>(entry.opcode),
                                                 sent.message.sequence, payload_of(entry, sent.message)));
    const auto parsed = parse(frame_of(bytes), entry.direction);
    const auto* received = std::get_if<Message>(&parsed);
    REQUIRE(received != nullptr);
    REQUIRE(received->opcode == sent.message.opcode);
    REQUIRE(received->sequence == sent.message.sequence);
    REQUIRE(received->operands == sent.message.operands);
    REQUIRE(std::ranges::equal(received->data, sent.message.data));
  }
}

TEST_CASE("every limit in the opcode table is kept, and a step beyond it refused") {
  halftone::test::Random random(2);
  for (const OpcodeEntry& entry : opcode_table) {
    for (std::size_t i = 0; i < entry.operands.size(); ++i) {
      const Operand& operand = entry.operands[i];
      if (size_of(operand.type) == 0) continue;
      auto sent = halftone::test::random_message(random, entry);
      std::uint32_t& value = sent.message.operands[i];
      const bool is_origin = std::ranges::any_of(
          entry.operands, [&](const Operand& other) { return other.origin == static_cast<int>(i); });
      const std::uint32_t most = most_beside(operand, sent.message.operands);
      INFO("seed 2, " << entry.name << " " << operand.name << ", at most " << most << " here");
      const auto fault_with = [&](std::uint32_t changed) {
        value = changed;
        return fault_of(entry, payload_of(entry, sent.message));
      };
      const std::uint32_t type_most = 0xFFFFFFFFU >> (32 - 8 * size_of(operand.type));
      if (!is_origin) {
        CHECK(fault_with(operand.least) == Fault::none);
        CHECK(fault_with(most) == Fault::none);
      }
      if (operand.least > 0) CHECK(fault_with(operand.least - 1) == Fault::out_of_limits);
      if (most < type_most) CHECK(fault_with(most + 1) == Fault::out_of_limits);
      if (operand.most < type_most) CHECK(fault_with(type_most) == Fault::out_of_limits);
    }
  }
}

TEST_CASE(
    "every operand takes the ends of its documented limits where the others are least, and not beyond") {
  for (const OpcodeEntry& entry : opcode_table) {
    Message least{entry.opcode, 0, {}, {}};
    Bytes data;
    for (std::size_t i = 0; i < entry.operands.size(); ++i) {
      const Operand& operand = entry.operands[i];
      if (size_of(operand.type) != 0)
        least.operands[i] = operand.least;
      else
        data.assign(operand.least * unit_of(operand.type), 'x');
    }
    for (std::size_t i = 0; i < entry.operands.size(); ++i) {
      const Operand& operand = entry.operands[i];
      const std::size_t size = size_of(operand.type);
      INFO(entry.name << " " << operand.name);
      const auto fault_with = [&](std::uint32_t value) {
        Message message = least;
        Bytes units = data;
        if (size != 0)
          message.operands[i] = value;
        else
          units.assign(value * unit_of(operand.type), 'x');
        message.data = units;
        return fault_of(entry, payload_of(entry, message));
      };
      const Fault beyond = size == 0 ? Fault::wrong_length : Fault::out_of_limits;
      const std::uint32_t type_most = size == 0 ? payload_limit : 0xFFFFFFFFU >> (32 - 8 * size);
      CHECK(fault_with(operand.least) == Fault::none);
      CHECK(fault_with(operand.most) == Fault::none);
      if (operand.least > 0) CHECK(fault_with(operand.least - 1) == beyond);
      if (operand.most < type_most) CHECK(fault_with(operand.most + 1) == beyond);
    }
  }
}

TEST_CASE("a rectangle may touch the screen's edges and not pass them") {
  const OpcodeEntry& entry = entry_of(Opcode::checksum);
  const auto fault_with = [&](std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
    return fault_of(entry, payload_of(entry, {Opcode::checksum, 0, {x, y, width, height}, {}}));
  };
  CHECK(fault_with(0, 0, 512, 512) == Fault::none);
  CHECK(fault_with(511, 511, 1, 1) == Fault::none);
  CHECK(fault_with(1, 0, 512, 1) == Fault::out_of_limits);
  CHECK(fault_with(0, 1, 1, 512) == Fault::out_of_limits);
  CHECK(fault_with(511, 0, 2, 1) == Fault::out_of_limits);
  CHECK(fault_with(512, 0, 1, 1) == Fault::out_of_limits);
  CHECK(fault_with(0, 0, 0, 1) == Fault::out_of_limits);
  CHECK(fault_with(0, 0, 1, 0) == Fault::out_of_limits);
  CHECK(fault_with(0, 0, 1, 65535) == Fault::out_of_limits);
}

TEST_CASE("a payload that is shorter or longer than the operands is refused") {
  halftone::test::Random random(3);
  for (const OpcodeEntry& entry : opcode_table) {
    const auto sent = halftone::test::random_message(random, entry);
    const Bytes payload = payload_of(entry, {sent.message.opcode, 0, sent.message.operands, {}});
    const bool has_data = !entry.operands.empty() && size_of(entry.operands.back().type) == 0;
    INFO(entry.name);
    for (std::size_t size = 0; size < payload.size(); ++size) {
      CHECK(fault_of(entry, Bytes(payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(size))) ==
            Fault::wrong_length);
    }
    Bytes longer = payload;
    longer.push_back('x');
    if (!has_data) {
      CHECK(fault_of(entry, longer) == Fault::wrong_length);
      continue;
    }
    const Operand& data = entry.operands.back();
    const std::size_t unit = unit_of(data.type);
    const std::size_t most = most_beside(data, sent.message.operands);
    const auto fault_with = [&](std::size_t bytes) {
      Bytes with_data = payload;
      with_data.resize(payload.size() + bytes, 'x');
      return fault_of(entry, with_data);
    };
    CHECK(fault_with(0) == Fault::wrong_length);
    CHECK(fault_with(data.least * unit) == Fault::none);
    CHECK(fault_with(most * unit) == Fault::none);
    if (most < data.most) CHECK(fault_with((most + 1) * unit) == Fault::out_of_limits);
    CHECK(fault_with(data.most * unit + 1) == Fault::wrong_length);
    if (unit > 1) CHECK(fault_with(data.least * unit + 1) == Fault::wrong_length);
  }
}

TEST_CASE("text is printable ASCII") {
  const OpcodeEntry& entry = entry_of(Opcode::identity);
  for (int character = 0; character < 256; ++character) {
    const Bytes name{'a', static_cast<std::uint8_t>(character)};
    const Bytes payload = payload_of(entry, {Opcode::identity, 0, {0, 1, 512, 512}, name});
    INFO("character " << character);
    CHECK(fault_of(entry, payload) ==
          (character >= ' ' && character <= '~' ? Fault::none : Fault::out_of_limits));
  }
}

TEST_CASE("an opcode that is not in the table, or travels the other way, is unknown") {
  for (const Direction direction : {Direction::to_device, Direction::to_host}) {
    for (int opcode = 0; opcode < 256; ++opcode) {
      const bool known = std::ranges::any_of(opcode_table, [&](const OpcodeEntry& entry) {
        return static_cast<int>(entry.opcode) == opcode && entry.direction == direction;
      });
      const auto parsed = parse({static_cast<std::uint8_t>(opcode), 9, {}}, direction);
      const auto* rejection = std::get_if<Rejection>(&parsed);
      INFO("opcode " << opcode);
      CHECK((rejection != nullptr && rejection->fault == Fault::unknown_opcode) == !known);
    }
  }
}
