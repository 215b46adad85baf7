#include "random_message.h"

#include <algorithm>
#include <cstddef>

namespace halftone::test {

namespace {

std::uint32_t random_value(Random& random, std::uint32_t least, std::uint32_t most) {
  switch (random() % 8) {
  case 0:
    return least;
  case 1:
    return most;
  case 2:
    return between(random, least, most);
  default:
    return between(random, least, std::min(most, least + std::min(most - least, 24U)));
  }
}

std::vector<std::uint8_t> random_data(Random& random, const protocol::Operand& operand, std::uint32_t most) {
  const bool is_text = operand.type == protocol::OperandType::text;
  std::vector<std::uint8_t> data(random_value(random, operand.least, most) * protocol::unit_of(operand.type));
  for (std::uint8_t& byte : data) {
    byte = static_cast<std::uint8_t>(is_text ? between(random, ' ', '~') : between(random, 0, 255));
  }
  return data;
}

} // namespace

std::uint32_t between(Random& random, std::uint32_t least, std::uint32_t most) {
  return std::uniform_int_distribution<std::uint32_t>(least, most)(random);
}

RandomMessage random_message(Random& random, const protocol::OpcodeEntry& entry) {
  RandomMessage result;
  result.message.opcode = entry.opcode;
  result.message.sequence = static_cast<std::uint32_t>(random());
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const protocol::Operand& operand = entry.operands[i];
    const std::uint32_t most = protocol::most_beside(operand, result.message.operands);
    if (protocol::size_of(operand.type) == 0) {
      result.data = random_data(random, operand, most);
      result.message.data = result.data;
      continue;
    }
    result.message.operands[i] = random_value(random, operand.least, most);
  }
  return result;
}

RandomMessage random_message(Random& random, protocol::Direction direction) {
  while (true) {
    const auto& entry = protocol::opcode_table[random() % protocol::opcode_table.size()];
    if (entry.direction == direction) return random_message(random, entry);
  }
}

std::vector<std::uint8_t> damaged(Random& random, std::vector<std::uint8_t> stream) {
  for (auto faults = random() % 4; faults > 0 && !stream.empty(); --faults) {
    const auto at = stream.begin() + static_cast<std::ptrdiff_t>(random() % stream.size());
    const auto count = static_cast<std::ptrdiff_t>(random() % 40);
    const auto end = stream.end() - at > count ? at + count : stream.end();
    switch (random() % 5) {
    case 0:
      *at = static_cast<std::uint8_t>(*at ^ 1U << random() % 8);
      break;
    case 1:
      stream.erase(at, end);
      break;
    case 2:
      stream.insert(at, static_cast<std::size_t>(count), std::uint8_t{0});
      break;
    case 3: {
      const std::vector<std::uint8_t> again(at, end);
      stream.insert(at, again.begin(), again.end());
      break;
    }
    default: // false beginnings of frames, some with a length that reaches far
      const std::vector<std::uint8_t> false_header{
          'M', '5', 0x11, 0, 0, 0, 1, static_cast<std::uint8_t>(random() % 17), 0};
      stream.insert(at, false_header.begin(),
                    false_header.begin() + static_cast<std::ptrdiff_t>(random() % 10));
    }
  }
  return stream;
}

} // namespace halftone::test
