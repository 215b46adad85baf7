#include <halftone/device/device.h>

#include <halftone/protocol/checksum.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string_view>
#include <variant>

namespace halftone::device {

namespace {

using protocol::channels;
using protocol::index_of;
using protocol::Message;
using protocol::Opcode;
using Replies = std::vector<std::uint8_t>;

constexpr std::string_view device_name = "M508R, reconstructed";

std::size_t offset_of(std::size_t x, std::size_t y) { return (y * protocol::screen_width + x) * channels; }

/// Of the commands whose layout begins with one.
Rectangle rectangle_of(const Message& command) {
  const auto operand = [&](std::size_t index) { return static_cast<std::uint16_t>(command.operands[index]); };
  return {operand(0), operand(1), operand(2), operand(3)};
}

std::span<const std::uint8_t> row_of(const Device& device, const Rectangle& rectangle, std::size_t row) {
  return std::span(device.image)
      .subspan(offset_of(rectangle.x, rectangle.y + row), rectangle.width * channels);
}

void reject(const protocol::Item& item, const protocol::Rejection& rejection, Registers& registers) {
  if (registers.error == protocol::Fault::none) {
    registers.error = rejection.fault;
    registers.error_sequence = rejection.sequence;
  }
  ++registers.errors;
  if (rejection.fault == protocol::Fault::damaged) registers.skipped += static_cast<std::uint32_t>(item.size);
}

void set_window(const Rectangle& window, Registers& registers) {
  registers.window = window;
  registers.x = window.x;
  registers.y = window.y;
}

void write_pixels(std::span<const std::uint8_t> pixels, Device& device) {
  const Rectangle& window = device.registers.window;
  std::uint16_t& x = device.registers.x;
  std::uint16_t& y = device.registers.y;
  while (!pixels.empty()) {
    const std::size_t to_row_end = std::size_t{window.x} + window.width - x;
    const std::size_t count = std::min(pixels.size() / channels, to_row_end);
    std::memcpy(&device.image[offset_of(x, y)], pixels.data(), count * channels);
    pixels = pixels.subspan(count * channels);
    x = static_cast<std::uint16_t>(x + count);
    if (count < to_row_end) return;
    x = window.x;
    y = y + 1 == window.y + window.height ? window.y : static_cast<std::uint16_t>(y + 1);
  }
}

void fill(const Message& command, std::vector<std::uint8_t>& image) {
  const auto channel = [&](std::size_t index) { return static_cast<std::uint8_t>(command.operands[index]); };
  const std::array<std::uint8_t, channels> color{channel(index_of(Opcode::fill, "red")),
                                                 channel(index_of(Opcode::fill, "green")),
                                                 channel(index_of(Opcode::fill, "blue"))};
  const Rectangle area = rectangle_of(command);
  std::uint8_t* const top = &image[offset_of(area.x, area.y)];
  for (std::size_t x = 0; x < area.width; ++x) std::memcpy(top + x * channels, color.data(), channels);
  for (std::size_t y = 1; y < area.height; ++y) {
    std::memcpy(&image[offset_of(area.x, area.y + y)], top, area.width * channels);
  }
}

void answer_identity(std::uint32_t sequence, Replies& replies) {
  const std::vector<std::uint8_t> name(device_name.begin(), device_name.end());
  append(replies, Message{Opcode::identity,
                          sequence,
                          {protocol::reconstructed_profile, protocol::protocol_version,
                           protocol::screen_width, protocol::screen_height},
                          name});
}

void answer_state(std::uint32_t sequence, const Registers& registers, Replies& replies) {
  append(replies, Message{Opcode::state,
                          sequence,
                          {static_cast<std::uint32_t>(registers.error), registers.error_sequence,
                           registers.errors, registers.commands, registers.skipped},
                          {}});
}

void answer_rows(const Message& command, const Device& device, Replies& replies) {
  const Rectangle area = rectangle_of(command);
  for (std::uint16_t row = 0; row < area.height; ++row) {
    append(replies, Message{Opcode::row,
                            command.sequence,
                            {area.x, std::uint32_t{area.y} + row},
                            row_of(device, area, row)});
  }
}

void answer_sum(const Message& command, const Device& device, Replies& replies) {
  const Rectangle area = rectangle_of(command);
  std::uint32_t sum = 0;
  for (std::uint16_t row = 0; row < area.height; ++row) {
    sum = protocol::checksum(row_of(device, area, row), sum);
  }
  append(replies, Message{Opcode::sum, command.sequence, {sum}, {}});
}

} // namespace

void Device::execute(const protocol::Item& item, std::vector<std::uint8_t>& replies) {
  if (const auto* rejection = std::get_if<protocol::Rejection>(&item.content)) {
    reject(item, *rejection, registers);
    return;
  }
  const Message& command = std::get<Message>(item.content);
  if (!protocol::entry_of(command.opcode).answer) ++registers.commands;
  switch (command.opcode) {
  case Opcode::identify:
    answer_identity(command.sequence, replies);
    break;
  case Opcode::reset:
    registers = {};
    std::ranges::fill(image, std::uint8_t{0});
    break;
  case Opcode::status:
    answer_state(command.sequence, registers, replies);
    break;
  case Opcode::window:
    set_window(rectangle_of(command), registers);
    break;
  case Opcode::pixels:
    write_pixels(command.data, *this);
    break;
  case Opcode::clear:
    std::ranges::fill(image, std::uint8_t{0});
    break;
  case Opcode::fill:
    fill(command, image);
    break;
  case Opcode::read:
    answer_rows(command, *this, replies);
    break;
  case Opcode::checksum:
    answer_sum(command, *this, replies);
    break;
  case Opcode::identity:
  case Opcode::state:
  case Opcode::row:
  case Opcode::sum:
    break; // replies: no decoder of commands lets one through
  }
}

} // namespace halftone::device
