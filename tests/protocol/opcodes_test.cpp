#include <halftone/protocol/opcodes.h>

#include <halftone/protocol/fault.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>

using namespace halftone::protocol;

TEST_CASE("opcodes ascend and have names of their own") {
  std::set<std::string_view> names;
  int last = 0; // 0 itself is fill between frames and no opcode
  for (const OpcodeEntry& entry : opcode_table) {
    INFO(entry.name);
    CHECK(static_cast<int>(entry.opcode) > last);
    last = static_cast<int>(entry.opcode);
    CHECK(names.insert(entry.name).second);
    CHECK(&entry_of(entry.opcode) == &entry);
    CHECK(find(static_cast<std::uint8_t>(entry.opcode), entry.direction) == &entry);
  }
}

TEST_CASE("a query is answered by the opcode with its highest bit set, and every reply answers a query") {
  std::set<Opcode> answers;
  for (const OpcodeEntry& entry : opcode_table) {
    INFO(entry.name);
    CHECK((entry.direction == Direction::to_host) == (static_cast<int>(entry.opcode) >= 0x80));
    if (!entry.answer) continue;
    CHECK(entry.direction == Direction::to_device);
    CHECK(entry_of(*entry.answer).direction == Direction::to_host);
    if (static_cast<int>(*entry.answer) == (static_cast<int>(entry.opcode) | 0x80))
      answers.insert(*entry.answer);
  }
  const auto replies = std::ranges::count(opcode_table, Direction::to_host, &OpcodeEntry::direction);
  CHECK(answers.size() == static_cast<std::size_t>(replies)); // each has the number of one that it answers
}

TEST_CASE("every layout fits into a payload, its data last") {
  for (const OpcodeEntry& entry : opcode_table) {
    REQUIRE(entry.operands.size() <= operand_limit);
    std::size_t largest = 0;
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < entry.operands.size(); ++i) {
      const Operand& operand = entry.operands[i];
      INFO(entry.name << " " << operand.name);
      CHECK(names.insert(operand.name).second);
      CHECK(operand.least <= operand.most);
      CHECK(operand.origin < static_cast<int>(i));
      if (operand.origin >= 0) {
        const Operand& origin = entry.operands[static_cast<std::size_t>(operand.origin)];
        CHECK(origin.most + operand.least <= operand.together); // something is left beside any origin
      }
      const std::size_t size = size_of(operand.type);
      if (size == 0) {
        CHECK(i + 1 == entry.operands.size());
        largest += operand.most * unit_of(operand.type);
      } else {
        CHECK(operand.most <= 0xFFFFFFFFU >> (32 - 8 * size));
        largest += size;
      }
    }
    INFO(entry.name);
    CHECK(largest <= payload_limit);
  }
}

TEST_CASE("commands that have a rectangle begin with it") {
  for (const OpcodeEntry& entry : opcode_table) {
    if (std::ranges::find(entry.operands, "width", &Operand::name) == entry.operands.end()) continue;
    if (entry.direction == Direction::to_host) continue;
    INFO(entry.name);
    constexpr std::array names{"x", "y", "width", "height"};
    CHECK(std::ranges::equal(entry.operands.first(4), names, {}, &Operand::name));
  }
}

TEST_CASE("faults stand at their codes") {
  for (std::size_t i = 0; i < fault_table.size(); ++i)
    CHECK(static_cast<std::size_t>(fault_table[i].fault) == i);
}
