#include "text.h"

#include <halftone/protocol/opcodes.h>
#include <halftone/protocol/words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <variant>

namespace halftone::inspect {

namespace {

std::string in_hexadecimal(std::uint8_t byte) {
  constexpr std::array digits{'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};
  return std::string("0x") + digits[byte >> 4] + digits[byte & 0xF];
}

// A unit of each repeats at most 256 times in runs, so that a row of one colour is short and all of it.
constexpr std::size_t units_looked_at = 512;
constexpr std::size_t data_width = 40; ///< characters

std::string_view name_of_units(protocol::OperandType type) {
  if (type == protocol::OperandType::pixels) return "pixels";
  return type == protocol::OperandType::runs ? "runs" : "bytes";
}

/// All of it, or as much as there is room for, and how much it is.
std::string shortened(std::span<const std::uint8_t> data, protocol::OperandType type) {
  const std::size_t unit = protocol::unit_of(type), count = data.size() / unit;
  std::string text;
  protocol::append_units(text, data.first(std::min(count, units_looked_at) * unit), unit);
  if (count <= units_looked_at && text.size() <= data_width) return text;
  if (text.size() > data_width) text.resize(text.rfind(' ', data_width));
  return text + " ... (" + std::to_string(count) + ' ' + std::string(name_of_units(type)) + ')';
}

std::string text_of(const protocol::Message& message) {
  const protocol::OpcodeEntry& entry = protocol::entry_of(message.opcode);
  std::string text(entry.name);
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const protocol::Operand& operand = entry.operands[i];
    if (operand.type == protocol::OperandType::text)
      text += ' ' + protocol::in_quotes(std::string(message.data.begin(), message.data.end()));
    else if (protocol::size_of(operand.type) == 0)
      text += shortened(message.data, operand.type);
    else
      text += ' ' + std::string(operand.name) + '=' + std::to_string(message.operands[i]);
  }
  return text;
}

std::string text_of(const protocol::Rejection& rejection, std::uint64_t size) {
  const std::string name(protocol::fault_table[static_cast<std::size_t>(rejection.fault)].name);
  if (rejection.fault == protocol::Fault::damaged)
    return std::to_string(size) + (size == 1 ? " damaged byte" : " damaged bytes");
  const protocol::OpcodeEntry* entry = protocol::find(rejection.opcode, protocol::Direction::to_device);
  return (entry == nullptr ? in_hexadecimal(rejection.opcode) : std::string(entry->name)) + ", " + name;
}

} // namespace

std::string text_of(const protocol::Item& item) {
  if (const auto* message = std::get_if<protocol::Message>(&item.content)) return text_of(*message);
  return text_of(std::get<protocol::Rejection>(item.content), item.size);
}

} // namespace halftone::inspect
