#include "stop.h"

#include <halftone/protocol/message.h>
#include <halftone/terminal/exit_code.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace halftone::m508 {

namespace {

std::uint64_t number(std::string_view digits, const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || stopped != end)
    throw terminal::ArgumentError("--until: expected a command's number, mark:NAME or frame:N, found \"" +
                                  text + "\"");
  return value;
}

bool is_mark(const recording::Step& step, const std::string& name) {
  const auto* command = std::get_if<protocol::Message>(&step.item.content);
  return command != nullptr && command->opcode == protocol::Opcode::mark &&
         std::ranges::equal(command->data, name, {}, {}, [](char c) { return static_cast<std::uint8_t>(c); });
}

} // namespace

Stop parse_stop(const std::string& text) {
  constexpr std::string_view mark = "mark:", frame = "frame:";
  if (text.starts_with(mark)) return AtMark{text.substr(mark.size())};
  if (text.starts_with(frame)) return AtFrame{number(std::string_view(text).substr(frame.size()), text)};
  return AfterCommand{number(text, text)};
}

bool is_reached(const Stop& stop, const recording::Step& step, const device::Device& device) {
  if (const auto* command = std::get_if<AfterCommand>(&stop)) return step.number >= command->number;
  if (const auto* mark = std::get_if<AtMark>(&stop)) return is_mark(step, mark->name);
  return is_reached(stop, device);
}

bool is_reached(const Stop& stop, const device::Device& device) {
  if (const auto* command = std::get_if<AfterCommand>(&stop)) return command->number == 0;
  if (const auto* frame = std::get_if<AtFrame>(&stop)) return fields(device.clock) >= frame->number;
  return false;
}

} // namespace halftone::m508
