#include "big_endian.h"
#include "printable.h"

#include <halftone/protocol/message.h>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace halftone::protocol {

namespace {

/// Pixels, bytes or text, which take up the rest of the payload.
Fault check_data(const Operand& operand, std::span<const std::uint8_t> data) {
  const std::size_t unit = unit_of(operand.type);
  const std::size_t count = data.size() / unit;
  if (data.size() % unit != 0 || count < operand.least || count > operand.most) return Fault::wrong_length;
  if (operand.type == OperandType::text && !std::ranges::all_of(data, is_printable))
    return Fault::out_of_limits;
  return Fault::none;
}

/// The value of a number, or the count of data.
std::size_t extent(const Operand& operand, std::size_t index, const Message& message) {
  return size_of(operand.type) == 0 ? message.data.size() / unit_of(operand.type) : message.operands[index];
}

bool within_limits(const OpcodeEntry& entry, std::size_t index, const Message& message) {
  const Operand& operand = entry.operands[index];
  const std::size_t value = extent(operand, index, message);
  return value >= operand.least && value <= most_beside(operand, message.operands);
}

/// Reads the payload by the layout; the lengths are settled before any value is judged.
Fault read_operands(const OpcodeEntry& entry, std::span<const std::uint8_t> payload, Message& message) {
  Fault data_fault = Fault::none;
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const Operand& operand = entry.operands[i];
    const std::size_t size = size_of(operand.type);
    if (size == 0) {
      data_fault = check_data(operand, payload);
      if (data_fault == Fault::wrong_length) return data_fault;
      message.data = payload;
      payload = {};
      continue;
    }
    if (payload.size() < size) return Fault::wrong_length;
    message.operands[i] = load_big_endian(payload.first(size));
    payload = payload.subspan(size);
  }
  if (!payload.empty()) return Fault::wrong_length;
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    if (!within_limits(entry, i, message)) return Fault::out_of_limits;
  }
  return data_fault;
}

} // namespace

std::variant<Message, Rejection> parse(const Frame& frame, Direction direction) {
  const OpcodeEntry* entry = find(frame.opcode, direction);
  if (entry == nullptr) return Rejection{Fault::unknown_opcode, frame.sequence, frame.opcode};
  Message message{entry->opcode, frame.sequence, {}, {}};
  const Fault fault = read_operands(*entry, frame.payload, message);
  if (fault != Fault::none) return Rejection{fault, frame.sequence, frame.opcode};
  return message;
}

void append(std::vector<std::uint8_t>& stream, const Message& message) {
  const OpcodeEntry& entry = entry_of(message.opcode);
  std::array<std::uint8_t, payload_limit> payload;
  std::size_t size = 0;
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const std::size_t bytes = size_of(entry.operands[i].type);
    store_big_endian(std::span(payload).subspan(size, bytes), message.operands[i]);
    size += bytes;
  }
  assert(message.data.size() <= payload.size() - size);
  std::ranges::copy(message.data, payload.begin() + static_cast<std::ptrdiff_t>(size));
  size += message.data.size();
  const Frame frame{static_cast<std::uint8_t>(message.opcode), message.sequence,
                    std::span(payload).first(size)};
  assert(std::holds_alternative<Message>(parse(frame, entry.direction)));
  append(stream, frame);
}

} // namespace halftone::protocol
