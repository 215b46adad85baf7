#include "explain.h"

#include <halftone/protocol/fault.h>
#include <halftone/protocol/opcodes.h>

#include <string_view>

namespace halftone::inspect {

namespace {

using protocol::Fault;
using protocol::OpcodeEntry;
using protocol::Operand;

/// As in "x 0 to 511, y 0 to 511, width 1 to 512 with x + width <= 512".
std::string limits_of(const OpcodeEntry& entry) {
  std::string text;
  for (const Operand& operand : entry.operands) {
    if (!text.empty()) text += ", ";
    text += operand.name;
    text += ' ' + std::to_string(operand.least) + " to " + std::to_string(operand.most);
    if (operand.origin >= 0) {
      const std::string_view origin = entry.operands[static_cast<std::size_t>(operand.origin)].name;
      text += " with " + std::string(origin) + " + " + std::string(operand.name) +
              " <= " + std::to_string(operand.together);
    }
  }
  return text;
}

/// As in "x u16, y u16, pixels 3 bytes each".
std::string layout_of(const OpcodeEntry& entry) {
  if (entry.operands.empty()) return "no operands at all";
  std::string text;
  for (const Operand& operand : entry.operands) {
    if (!text.empty()) text += ", ";
    text += operand.name;
    const std::size_t size = protocol::size_of(operand.type);
    const std::size_t unit = protocol::unit_of(operand.type);
    if (size != 0)
      text += size == 1 ? " 1 byte" : ' ' + std::to_string(size) + " bytes";
    else
      text += ' ' + std::to_string(operand.least) + " to " + std::to_string(operand.most) +
              (unit == 1 ? " bytes" : " of " + std::to_string(unit) + " bytes");
  }
  return text;
}

} // namespace

Explanation explain(const protocol::Rejection& rejection) {
  const OpcodeEntry* entry = protocol::find(rejection.opcode, protocol::Direction::to_device);
  const std::string name(entry != nullptr ? entry->name : "the command");
  switch (rejection.fault) {
  case Fault::damaged:
    return {"bytes that are no frame, with a wrong checksum or cut off on the way; they come after sequence "
            "number " +
                std::to_string(rejection.sequence),
            "compare the framing and the checksum with docs/protocol.md, then look at the link"};
  case Fault::unknown_opcode:
    return {"no command has this opcode", "the opcodes are listed in docs/protocol.md"};
  case Fault::wrong_length:
    return {"the payload is not as long as the operands are",
            entry == nullptr ? std::string() : name + " takes " + layout_of(*entry)};
  case Fault::out_of_limits:
    return {"an operand is outside of its limits",
            entry == nullptr ? std::string() : name + " takes " + limits_of(*entry)};
  case Fault::none:
    break;
  }
  return {};
}

std::string why_redundant(const protocol::Message& message) {
  switch (message.opcode) {
  case protocol::Opcode::pixels:
  case protocol::Opcode::runs:
  case protocol::Opcode::repeat:
  case protocol::Opcode::fill:
  case protocol::Opcode::copy:
  case protocol::Opcode::clear:
  case protocol::Opcode::overlay_bits:
  case protocol::Opcode::overlay_fill:
    return "the pixels have these values already";
  default:
    return "everything is set like this already";
  }
}

std::string of_them(std::uint64_t count, const std::string& name) {
  return std::to_string(count) + ' ' + name + (count == 1 ? "" : "s");
}

std::string text_of(const device::Rectangle& r) {
  return std::to_string(r.width) + " x " + std::to_string(r.height) + " at (" + std::to_string(r.x) + ", " +
         std::to_string(r.y) + ')';
}

} // namespace halftone::inspect
