#include <halftone/device/addressed.h>

#include "memory.h"

#include <algorithm>

namespace halftone::device {

namespace {

using protocol::index_of;
using protocol::Message;
using protocol::Opcode;

Plane plane_of(std::uint8_t buffer) { return buffer == 0 ? Plane::image_0 : Plane::image_1; }

/// `count` pixels from the writing position on: the rest of a row, whole rows, the beginning of a row, and
/// once again from the window's top.
std::vector<Region> written(const Registers& r, std::uint32_t count) {
  const Rectangle& window = r.window;
  const Plane plane = plane_of(r.written);
  if (count >= std::uint32_t{window.width} * window.height) return {{plane, window}};
  std::vector<Region> regions;
  std::uint32_t x = r.x, y = r.y;
  while (count != 0) {
    const std::uint32_t columns = std::uint32_t{window.x} + window.width - x;
    const std::uint32_t rows_left = std::uint32_t{window.y} + window.height - y;
    const std::uint32_t width = std::min(columns, count);
    const bool is_whole_row = x == window.x && count >= window.width;
    const std::uint32_t rows = is_whole_row ? std::min(rows_left, count / window.width) : 1;
    regions.push_back({plane,
                       {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                        static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(rows)}});
    count -= width * rows;
    x = window.x;
    y = rows == rows_left ? window.y : y + rows;
  }
  return regions;
}

} // namespace

Rectangle rectangle_of(const protocol::Message& command) {
  const auto operand = [&](std::size_t index) { return static_cast<std::uint16_t>(command.operands[index]); };
  return {operand(0), operand(1), operand(2), operand(3)};
}

std::vector<Region> addressed(const Registers& r, const Message& command) {
  const auto operand = [&](std::size_t index) { return static_cast<std::uint16_t>(command.operands[index]); };
  switch (command.opcode) {
  case Opcode::reset:
    return {{Plane::image_0, {}}, {Plane::image_1, {}}, {Plane::overlay, {}}};
  case Opcode::pixels:
  case Opcode::runs:
  case Opcode::repeat:
    return written(r, pixels_of(command));
  case Opcode::clear:
    return {{plane_of(r.written), {}}};
  case Opcode::fill:
    return {{plane_of(r.written), rectangle_of(command)}};
  case Opcode::copy: {
    const Rectangle from = rectangle_of(command);
    return {{plane_of(r.written),
             {operand(index_of(Opcode::copy, "to_x")), operand(index_of(Opcode::copy, "to_y")), from.width,
              from.height}}};
  }
  case Opcode::overlay_bits:
    return {{Plane::overlay,
             {static_cast<std::uint16_t>(8 * operand(index_of(Opcode::overlay_bits, "x8"))),
              operand(index_of(Opcode::overlay_bits, "y")),
              static_cast<std::uint16_t>(8 * command.data.size()), 1}}};
  case Opcode::overlay_fill:
    return {{Plane::overlay, rectangle_of(command)}};
  default:
    return {};
  }
}

} // namespace halftone::device
