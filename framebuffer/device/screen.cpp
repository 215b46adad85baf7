#include <halftone/device/screen.h>

#include "memory.h"

#include <algorithm>
#include <cstring>

namespace halftone::device {

namespace {

using protocol::channels;
using protocol::screen_height;
using protocol::screen_width;

void set(std::span<std::uint8_t> row, std::uint32_t x, const Pixel& color) {
  std::memcpy(&row[x * channels], color.data(), channels);
}

/// A row of the image as it stands in memory, panned and zoomed.
void fetch(const Device& device, std::uint32_t y, std::span<std::uint8_t> row) {
  const Registers& r = device.registers;
  const std::uint32_t source_y = (r.pan_y + (y >> r.zoom)) % screen_height;
  const std::uint8_t* const source = &device.images[r.shown][offset_of(0, source_y)];
  if (r.zoom == 0) {
    const std::size_t right = (screen_width - std::size_t{r.pan_x}) * channels;
    std::memcpy(row.data(), source + r.pan_x * channels, right);
    std::memcpy(row.data() + right, source, row.size() - right);
    return;
  }
  for (std::uint32_t x = 0; x < screen_width; ++x) {
    const std::uint32_t source_x = (r.pan_x + (x >> r.zoom)) % screen_width;
    std::memcpy(&row[x * channels], source + source_x * channels, channels);
  }
}

/// Read mask and look-up tables.
void look_up(const Device& device, std::span<std::uint8_t> row) {
  const Pixel& mask = device.registers.read_mask;
  for (std::size_t c = 0; c < channels; ++c) {
    const Lut& lut = device.luts[c];
    for (std::size_t i = c; i < row.size(); i += channels) row[i] = lut[row[i] & mask[c]];
  }
}

void draw_overlay(const Device& device, std::uint32_t y, std::span<std::uint8_t> row) {
  const std::uint8_t* const bits = &device.overlay[y * (screen_width / 8)];
  for (std::uint32_t byte = 0; byte < screen_width / 8; ++byte) {
    for (std::uint32_t bit = 0; bits[byte] != 0 && bit < 8; ++bit) {
      if ((bits[byte] << bit & 0x80) != 0) set(row, byte * 8 + bit, device.registers.overlay.color);
    }
  }
}

void draw_cursor(const Device& device, std::uint32_t y, std::span<std::uint8_t> row) {
  const Registers& r = device.registers;
  if (y < r.cursor_y || y - r.cursor_y >= cursor_size) return;
  const std::size_t byte = (y - r.cursor_y) * 2;
  const std::uint32_t bits = device.cursor_pattern[byte] * 256U + device.cursor_pattern[byte + 1];
  for (std::uint32_t i = 0; i < cursor_size && r.cursor_x + i < screen_width; ++i) {
    if ((bits << i & 0x8000) != 0) set(row, r.cursor_x + i, r.cursor.color);
  }
}

void draw_border(const Registers& r, std::uint32_t y, std::span<std::uint8_t> row) {
  const bool whole_row = y < r.border || y >= std::uint32_t{screen_height} - r.border;
  for (std::uint32_t x = 0; x < screen_width; ++x) {
    if (whole_row || x < r.border || x >= std::uint32_t{screen_width} - r.border) set(row, x, r.border_color);
  }
}

} // namespace

bool is_shown(const Layer& layer, const Clock& clock) {
  return layer.on && (layer.blink == 0 || fields(clock) / layer.blink % 2 == 0);
}

void scan_out(const Device& device, std::uint32_t y, std::span<std::uint8_t> row) {
  const Registers& r = device.registers;
  if (r.blank) {
    std::ranges::fill(row, std::uint8_t{0});
    return;
  }
  fetch(device, y, row);
  look_up(device, row);
  if (is_shown(r.overlay, device.clock)) draw_overlay(device, y, row);
  if (is_shown(r.cursor, device.clock)) draw_cursor(device, y, row);
  if (r.border != 0) draw_border(r, y, row);
}

Bytes screen(const Device& device) {
  Bytes pixels(image_size);
  for (std::uint32_t y = 0; y < screen_height; ++y)
    scan_out(device, y, std::span(pixels).subspan(offset_of(0, y), screen_width * channels));
  return pixels;
}

} // namespace halftone::device
