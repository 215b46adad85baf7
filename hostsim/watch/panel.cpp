#include <halftone/watch/panel.h>

#include <halftone/protocol/message.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <variant>

namespace halftone::watch {

namespace {

using display::Tables;
using protocol::Message;
using protocol::Opcode;
using protocol::screen_height;
using protocol::screen_width;

constexpr std::uint32_t all_channels = 0b111;
constexpr int zoom_limit = 3;

void put(device::Bytes& bytes, Opcode opcode,
         const std::array<std::uint32_t, protocol::operand_limit>& operands,
         std::span<const std::uint8_t> data = {}) {
  append(bytes, Message{opcode, 0, operands, data});
}

std::uint32_t wrapped(int value, int size) {
  return static_cast<std::uint32_t>((value % size + size) % size);
}

void pan_to(device::Bytes& bytes, int x, int y) {
  put(bytes, Opcode::pan, {wrapped(x, screen_width), wrapped(y, screen_height)});
}

void zoom(device::Bytes& bytes, const display::Zoom& zoom, const device::Registers& registers) {
  const int before = registers.zoom, after = std::clamp(before + zoom.steps, 0, zoom_limit);
  if (after == before) return;
  put(bytes, Opcode::zoom, {static_cast<std::uint32_t>(after)});
  pan_to(bytes, registers.pan_x + (zoom.x >> before) - (zoom.x >> after),
         registers.pan_y + (zoom.y >> before) - (zoom.y >> after));
}

/// A hue for each level, from blue over green to red, that gets lighter with it.
device::Pixel false_color(int level) {
  const double angle =
      (1 - level / 255.0) * 4 / 3 * std::numbers::pi; // of the circle of hues: 240 degrees to 0
  device::Pixel color;
  for (std::size_t c = 0; c < color.size(); ++c) {
    const double hue = 0.5 + 0.5 * std::cos(angle - static_cast<double>(c) * 2 / 3 * std::numbers::pi);
    color[c] = static_cast<std::uint8_t>(std::lround(255 * hue * (0.25 + 0.75 * level / 255.0)));
  }
  return color;
}

/// An entry of a table that has no ramp.
std::uint8_t entry(Tables tables, int level, std::size_t channel) {
  constexpr int steps = 8;
  if (tables == Tables::contours) return static_cast<std::uint8_t>(level / (256 / steps) * 255 / (steps - 1));
  return false_color(level)[channel];
}

void set_tables(device::Bytes& bytes, Tables tables) {
  if (tables == Tables::linear) return put(bytes, Opcode::ramp, {all_channels, 0, 256, 0, 255});
  if (tables == Tables::negative) return put(bytes, Opcode::ramp, {all_channels, 0, 256, 255, 0});
  for (std::size_t c = 0; c < protocol::channels; ++c) {
    device::Lut lut;
    for (int level = 0; level < 256; ++level) lut[static_cast<std::size_t>(level)] = entry(tables, level, c);
    put(bytes, Opcode::lut, {1U << c, 0}, lut);
  }
}

} // namespace

device::Bytes commands_for(const display::Event& event, const device::Registers& registers) {
  device::Bytes bytes;
  if (const auto* pan = std::get_if<display::Pan>(&event)) {
    pan_to(bytes, registers.pan_x + pan->right, registers.pan_y + pan->down);
  } else if (const auto* asked = std::get_if<display::Zoom>(&event)) {
    zoom(bytes, *asked, registers);
  } else if (std::holds_alternative<display::Home>(event)) {
    put(bytes, Opcode::zoom, {0});
    pan_to(bytes, 0, 0);
  } else if (const auto* tables = std::get_if<display::SetTables>(&event)) {
    set_tables(bytes, tables->tables);
  } else if (std::holds_alternative<display::OtherBuffer>(event)) {
    put(bytes, Opcode::buffers, {registers.written, registers.shown == 0 ? 1U : 0U});
  } else if (std::holds_alternative<display::ToggleOverlay>(event)) {
    const device::Layer& overlay = registers.overlay;
    put(bytes, Opcode::overlay,
        {overlay.on ? 0U : 1U, overlay.blink, overlay.color[0], overlay.color[1], overlay.color[2]});
  }
  return bytes;
}

} // namespace halftone::watch
