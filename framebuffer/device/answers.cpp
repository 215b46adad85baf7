#include "answers.h"

#include "memory.h"

#include <halftone/device/addressed.h>
#include <halftone/device/screen.h>

#include <halftone/protocol/checksum.h>

#include <span>
#include <string_view>

namespace halftone::device {

namespace {

using protocol::channels;
using protocol::index_of;
using protocol::Message;
using protocol::Opcode;
using protocol::screen_width;

constexpr std::string_view device_name = "M508R, reconstructed";

void identify(const Message& query, Bytes& replies) {
  const Bytes name(device_name.begin(), device_name.end());
  append(replies, Message{Opcode::identity,
                          query.sequence,
                          {protocol::reconstructed_profile, protocol::protocol_version, screen_width,
                           protocol::screen_height},
                          name});
}

void tell_state(const Message& query, const Device& device, Bytes& replies) {
  const Registers& r = device.registers;
  append(replies, Message{Opcode::state,
                          query.sequence,
                          {static_cast<std::uint32_t>(r.error), r.error_sequence, r.errors, r.commands,
                           r.skipped, fields(device.clock)},
                          {}});
}

void read_image(const Message& query, const Device& device, Bytes& replies) {
  const Rectangle area = rectangle_of(query);
  for (std::uint32_t row = 0; row < area.height; ++row)
    append(replies, Message{Opcode::row, query.sequence, {area.x, area.y + row}, row_of(device, area, row)});
}

void read_screen(const Message& query, const Device& device, Bytes& replies) {
  const Rectangle area = rectangle_of(query);
  std::array<std::uint8_t, screen_width * channels> pixels;
  for (std::uint32_t y = area.y; y < std::uint32_t{area.y} + area.height; ++y) {
    scan_out(device, y, pixels);
    append(replies, Message{Opcode::row,
                            query.sequence,
                            {area.x, y},
                            std::span(pixels).subspan(area.x * channels, area.width * channels)});
  }
}

void sum(const Message& query, const Device& device, Bytes& replies) {
  const Rectangle area = rectangle_of(query);
  std::uint32_t checksum = 0;
  for (std::uint32_t row = 0; row < area.height; ++row)
    checksum = protocol::checksum(row_of(device, area, row), checksum);
  append(replies, Message{Opcode::sum, query.sequence, {checksum}, {}});
}

void read_lut(const Message& query, const Device& device, Bytes& replies) {
  const std::uint32_t channel = query.operands[index_of(Opcode::read_lut, "channel")];
  append(replies, Message{Opcode::table, query.sequence, {channel}, device.luts[channel]});
}

void read_overlay(const Message& query, const Device& device, Bytes& replies) {
  constexpr std::size_t row_size = screen_width / 8;
  const std::uint32_t first = query.operands[index_of(Opcode::read_overlay, "y")];
  const std::uint32_t count = query.operands[index_of(Opcode::read_overlay, "height")];
  for (std::uint32_t y = first; y < first + count; ++y)
    append(replies,
           Message{
               Opcode::bits, query.sequence, {y}, std::span(device.overlay).subspan(y * row_size, row_size)});
}

} // namespace

void answer(const Message& query, const Device& device, Bytes& replies) {
  switch (query.opcode) {
  case Opcode::identify:
    return identify(query, replies);
  case Opcode::status:
    return tell_state(query, device, replies);
  case Opcode::read:
    return read_image(query, device, replies);
  case Opcode::checksum:
    return sum(query, device, replies);
  case Opcode::read_screen:
    return read_screen(query, device, replies);
  case Opcode::read_lut:
    return read_lut(query, device, replies);
  case Opcode::read_overlay:
    return read_overlay(query, device, replies);
  default:
    return; // no query
  }
}

} // namespace halftone::device
