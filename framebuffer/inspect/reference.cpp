#include <halftone/inspect/reference.h>

#include "text.h"

#include <variant>

namespace halftone::inspect {

using protocol::Opcode;

void Sections::follow(const recording::Step& step) {
  const protocol::Message* message = message_of(step);
  if (message != nullptr && message->opcode == Opcode::mark)
    section_.assign(message->data.begin(), message->data.end());
}

Reference Sections::refer_to(const recording::Step& step) const {
  const protocol::Message* message = message_of(step);
  const std::uint32_t sequence =
      message != nullptr ? message->sequence : std::get<protocol::Rejection>(step.item.content).sequence;
  const std::string text = step.is_restart ? "the device restarts, through no command" : text_of(step.item);
  return {step.number, step.offset, step.session, sequence, text, section_};
}

const protocol::Message* message_of(const recording::Step& step) {
  return std::get_if<protocol::Message>(&step.item.content);
}

bool is_query(const protocol::Message& message) {
  return protocol::entry_of(message.opcode).answer.has_value();
}

bool is_masked_out(const device::Registers& registers, const protocol::Message& message) {
  switch (message.opcode) {
  case Opcode::pixels:
  case Opcode::runs:
  case Opcode::repeat:
  case Opcode::fill:
  case Opcode::copy:
    return registers.write_mask == device::Pixel{};
  default:
    return false; // the mask is not for the others
  }
}

} // namespace halftone::inspect
