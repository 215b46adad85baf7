#include <halftone/device/device.h>

#include "answers.h"
#include "memory.h"

#include <halftone/device/addressed.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <variant>

namespace halftone::device {

namespace {

using protocol::index_of;
using protocol::Message;
using protocol::Opcode;

void reject(const protocol::Item& item, const protocol::Rejection& rejection, Registers& registers) {
  if (registers.error == protocol::Fault::none) {
    registers.error = rejection.fault;
    registers.error_sequence = rejection.sequence;
  }
  ++registers.errors;
  if (rejection.fault == protocol::Fault::damaged) registers.skipped += static_cast<std::uint32_t>(item.size);
}

/// Everything but the clock as at power-on, in the memory that is there.
void reset(Device& device) {
  device.registers = {};
  for (Bytes& image : device.images) std::ranges::fill(image, std::uint8_t{0});
  std::ranges::fill(device.overlay, std::uint8_t{0});
  device.cursor_pattern = {};
  device.luts.fill(linear_lut());
}

/// Three operands from `first` on.
Pixel pixel_of(const Message& command, std::size_t first) {
  const auto operand = [&](std::size_t i) { return static_cast<std::uint8_t>(command.operands[first + i]); };
  return {operand(0), operand(1), operand(2)};
}

std::uint16_t word(const Message& command, std::size_t index) {
  return static_cast<std::uint16_t>(command.operands[index]);
}

std::uint8_t byte(const Message& command, std::size_t index) {
  return static_cast<std::uint8_t>(command.operands[index]);
}

Layer layer_of(const Message& command, std::size_t on) {
  return {command.operands[on] != 0, byte(command, on + 1), pixel_of(command, on + 2)};
}

void set_window(const Message& command, Registers& registers) {
  registers.window = rectangle_of(command);
  registers.x = registers.window.x;
  registers.y = registers.window.y;
}

void write_runs(Device& device, std::span<const std::uint8_t> runs) {
  for (; !runs.empty(); runs = runs.subspan(4))
    write_color(device, {runs[1], runs[2], runs[3]}, runs[0] + 1U);
}

/// Calls set(entry, i) for the entries first + i of the tables that `channels` names.
template<typename Set>
void for_entries(Device& device, std::uint32_t channels, std::size_t first, std::size_t count, Set set) {
  for (std::size_t c = 0; c < protocol::channels; ++c) {
    if ((channels >> c & 1) == 0) continue;
    for (std::size_t i = 0; i < count; ++i) set(device.luts[c][first + i], i);
  }
}

void set_lut(Device& device, const Message& command) {
  for_entries(device, command.operands[index_of(Opcode::lut, "channels")],
              command.operands[index_of(Opcode::lut, "first")], command.data.size(),
              [&](std::uint8_t& entry, std::size_t i) { entry = command.data[i]; });
}

void set_ramp(Device& device, const Message& command) {
  const auto operand = [&](std::size_t index) { return static_cast<int>(command.operands[index]); };
  const int count = operand(index_of(Opcode::ramp, "count"));
  const int from = operand(index_of(Opcode::ramp, "from"));
  const int rise = operand(index_of(Opcode::ramp, "to")) - from;
  for_entries(device, command.operands[index_of(Opcode::ramp, "channels")],
              command.operands[index_of(Opcode::ramp, "first")], static_cast<std::size_t>(count),
              [&](std::uint8_t& entry, std::size_t i) {
                const int twice = 2 * static_cast<int>(i) * std::abs(rise) + (count - 1);
                const int change = twice / (2 * (count - 1)); // rounded to the nearest, halves up
                entry = static_cast<std::uint8_t>(rise < 0 ? from - change : from + change);
              });
}

void set_cursor(const Message& command, Registers& registers) {
  registers.cursor_x = word(command, index_of(Opcode::cursor, "x"));
  registers.cursor_y = word(command, index_of(Opcode::cursor, "y"));
  registers.cursor = layer_of(command, index_of(Opcode::cursor, "on"));
}

} // namespace

Lut linear_lut() {
  Lut lut;
  std::iota(lut.begin(), lut.end(), std::uint8_t{0});
  return lut;
}

void Device::execute(const protocol::Item& item, Bytes& replies) {
  execute(item);
  if (const auto* command = std::get_if<Message>(&item.content)) answer(*command, *this, replies);
}

void Device::execute(const protocol::Item& item) {
  clock.transfer(item.size);
  if (const auto* rejection = std::get_if<protocol::Rejection>(&item.content)) {
    reject(item, *rejection, registers);
    return;
  }
  const Message& command = std::get<Message>(item.content);
  clock.execute(command);
  if (protocol::entry_of(command.opcode).answer) return;
  ++registers.commands;
  switch (command.opcode) {
  case Opcode::reset:
    reset(*this);
    break;
  case Opcode::wait:
    clock.wait(command.operands[index_of(Opcode::wait, "fields")]);
    break;
  case Opcode::window:
    set_window(command, registers);
    break;
  case Opcode::pixels:
    write_pixels(*this, command.data);
    break;
  case Opcode::clear:
    std::ranges::fill(images[registers.written], std::uint8_t{0});
    break;
  case Opcode::fill:
    fill(*this, rectangle_of(command), pixel_of(command, index_of(Opcode::fill, "red")));
    break;
  case Opcode::runs:
    write_runs(*this, command.data);
    break;
  case Opcode::repeat:
    write_color(*this, pixel_of(command, index_of(Opcode::repeat, "red")),
                command.operands[index_of(Opcode::repeat, "count")]);
    break;
  case Opcode::copy:
    copy(*this, rectangle_of(command), word(command, index_of(Opcode::copy, "to_x")),
         word(command, index_of(Opcode::copy, "to_y")), byte(command, index_of(Opcode::copy, "from")));
    break;
  case Opcode::write_mask:
    registers.write_mask = pixel_of(command, 0);
    break;
  case Opcode::buffers:
    registers.written = byte(command, index_of(Opcode::buffers, "written"));
    registers.shown = byte(command, index_of(Opcode::buffers, "shown"));
    break;
  case Opcode::lut:
    set_lut(*this, command);
    break;
  case Opcode::ramp:
    set_ramp(*this, command);
    break;
  case Opcode::read_mask:
    registers.read_mask = pixel_of(command, 0);
    break;
  case Opcode::pan:
    registers.pan_x = word(command, index_of(Opcode::pan, "x"));
    registers.pan_y = word(command, index_of(Opcode::pan, "y"));
    break;
  case Opcode::zoom:
    registers.zoom = byte(command, index_of(Opcode::zoom, "shift"));
    break;
  case Opcode::blank:
    registers.blank = command.operands[index_of(Opcode::blank, "on")] != 0;
    break;
  case Opcode::border:
    registers.border = byte(command, index_of(Opcode::border, "thickness"));
    registers.border_color = pixel_of(command, index_of(Opcode::border, "red"));
    break;
  case Opcode::overlay:
    registers.overlay = layer_of(command, index_of(Opcode::overlay, "on"));
    break;
  case Opcode::overlay_bits:
    write_overlay(*this, command.operands[index_of(Opcode::overlay_bits, "x8")],
                  command.operands[index_of(Opcode::overlay_bits, "y")], command.data);
    break;
  case Opcode::overlay_fill:
    fill_overlay(*this, rectangle_of(command),
                 command.operands[index_of(Opcode::overlay_fill, "value")] != 0);
    break;
  case Opcode::cursor:
    set_cursor(command, registers);
    break;
  case Opcode::cursor_pattern:
    std::ranges::copy(command.data, cursor_pattern.begin());
    break;
  default:
    break; // mark does nothing; queries change no more than the clock; no decoder of commands lets a reply
           // through
  }
}

} // namespace halftone::device
