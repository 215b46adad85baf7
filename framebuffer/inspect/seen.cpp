#include <halftone/inspect/seen.h>

#include <halftone/device/screen.h>

namespace halftone::inspect {

namespace {

using protocol::screen_height;
using protocol::screen_width;

bool is_border(const device::Registers& r, std::uint32_t x, std::uint32_t y) {
  return x < r.border || y < r.border || x + r.border >= screen_width || y + r.border >= screen_height;
}

bool is_cursor(const device::Device& device, std::uint32_t x, std::uint32_t y) {
  const device::Registers& r = device.registers;
  if (!device::is_shown(r.cursor, device.clock) || x < r.cursor_x || y < r.cursor_y) return false;
  const std::uint32_t column = x - r.cursor_x, row = y - r.cursor_y;
  if (column >= device::cursor_size || row >= device::cursor_size) return false;
  return (device.cursor_pattern[row * 2 + column / 8] >> (7 - column % 8) & 1) != 0;
}

Decider decider_at(const device::Device& device, std::uint16_t x, std::uint16_t y) {
  const device::Registers& r = device.registers;
  if (r.blank) return Decider::blank;
  if (is_border(r, x, y)) return Decider::border;
  if (is_cursor(device, x, y)) return Decider::cursor;
  const bool has_overlay = value_at(device, {device::Plane::overlay, x, y})[0] != 0;
  return has_overlay && device::is_shown(r.overlay, device.clock) ? Decider::overlay : Decider::image;
}

} // namespace

std::string_view name_of(Decider decider) {
  switch (decider) {
  case Decider::image:
    return "image";
  case Decider::overlay:
    return "overlay";
  case Decider::cursor:
    return "cursor";
  case Decider::border:
    return "border";
  case Decider::blank:
    break;
  }
  return "blank";
}

Seen seen_at(const device::Device& device, std::uint16_t x, std::uint16_t y) {
  const device::Registers& r = device.registers;
  Seen seen;
  seen.decider = decider_at(device, x, y);
  seen.source = {r.shown == 0 ? device::Plane::image_0 : device::Plane::image_1,
                 static_cast<std::uint16_t>((r.pan_x + (x >> r.zoom)) % screen_width),
                 static_cast<std::uint16_t>((r.pan_y + (y >> r.zoom)) % screen_height)};
  seen.memory = value_at(device, seen.source);
  for (std::size_t c = 0; c < protocol::channels; ++c) {
    seen.masked[c] = seen.memory[c] & r.read_mask[c];
    seen.through[c] = device.luts[c][seen.masked[c]];
  }
  switch (seen.decider) {
  case Decider::image:
    seen.color = seen.through;
    break;
  case Decider::overlay:
    seen.color = r.overlay.color;
    break;
  case Decider::cursor:
    seen.color = r.cursor.color;
    break;
  case Decider::border:
    seen.color = r.border_color;
    break;
  case Decider::blank:
    break; // black
  }
  return seen;
}

} // namespace halftone::inspect
