#include "memory.h"

#include <algorithm>
#include <cstring>

namespace halftone::device {

namespace {

using protocol::channels;
using protocol::screen_width;

constexpr Pixel open_mask{0xFF, 0xFF, 0xFF};

/// The bits of the mask from `value`, the others from `old`.
std::uint8_t merge(std::uint8_t old, std::uint8_t value, std::uint8_t mask) {
  return static_cast<std::uint8_t>((old & ~mask) | (value & mask));
}

/// Pixels side by side, in one row.
void put(Device& device, std::size_t x, std::size_t y, std::span<const std::uint8_t> pixels) {
  const Pixel& mask = device.registers.write_mask;
  std::uint8_t* const memory = &device.images[device.registers.written][offset_of(x, y)];
  if (mask == open_mask) {
    std::memcpy(memory, pixels.data(), pixels.size());
    return;
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) memory[i] = merge(memory[i], pixels[i], mask[i % channels]);
}

/// So many pixels of one colour.
void put(Device& device, std::size_t x, std::size_t y, const Pixel& color, std::size_t count) {
  const Pixel& mask = device.registers.write_mask;
  std::uint8_t* const memory = &device.images[device.registers.written][offset_of(x, y)];
  if (mask == open_mask) {
    const std::size_t size = count * channels;
    std::memcpy(memory, color.data(), channels);
    for (std::size_t done = channels; done < size; done *= 2)
      std::memcpy(memory + done, memory, std::min(done, size - done));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) {
      std::uint8_t& byte = memory[i * channels + c];
      byte = merge(byte, color[c], mask[c]);
    }
  }
}

/// Moves the writing position over `count` pixels and calls put_part(x, y, first, count) for the part in each
/// row; first counts from 0.
template<typename PutPart>
void advance(Registers& registers, std::size_t count, PutPart put_part) {
  const Rectangle& window = registers.window;
  for (std::size_t first = 0; first < count;) {
    const std::size_t to_row_end = std::size_t{window.x} + window.width - registers.x;
    const std::size_t part = std::min(count - first, to_row_end);
    put_part(registers.x, registers.y, first, part);
    first += part;
    registers.x = static_cast<std::uint16_t>(registers.x + part);
    if (part < to_row_end) return;
    registers.x = window.x;
    const bool is_last_row = registers.y + 1 == window.y + window.height;
    registers.y = is_last_row ? window.y : static_cast<std::uint16_t>(registers.y + 1);
  }
}

} // namespace

std::span<const std::uint8_t> row_of(const Device& device, const Rectangle& rectangle, std::size_t row) {
  return std::span(device.images[device.registers.written])
      .subspan(offset_of(rectangle.x, rectangle.y + row), rectangle.width * channels);
}

void write_pixels(Device& device, std::span<const std::uint8_t> pixels) {
  advance(device.registers, pixels.size() / channels,
          [&](std::size_t x, std::size_t y, std::size_t first, std::size_t count) {
            put(device, x, y, pixels.subspan(first * channels, count * channels));
          });
}

void write_color(Device& device, const Pixel& color, std::uint32_t count) {
  advance(device.registers, count, [&](std::size_t x, std::size_t y, std::size_t, std::size_t part) {
    put(device, x, y, color, part);
  });
}

void fill(Device& device, const Rectangle& area, const Pixel& color) {
  for (std::size_t row = 0; row < area.height; ++row) put(device, area.x, area.y + row, color, area.width);
}

void copy(Device& device, const Rectangle& area, std::uint16_t to_x, std::uint16_t to_y, std::uint8_t from) {
  const std::size_t row_size = area.width * channels;
  Bytes source(row_size * area.height); // whole, since the two may overlap
  for (std::size_t row = 0; row < area.height; ++row)
    std::memcpy(&source[row * row_size], &device.images[from][offset_of(area.x, area.y + row)], row_size);
  for (std::size_t row = 0; row < area.height; ++row)
    put(device, to_x, to_y + row, std::span(source).subspan(row * row_size, row_size));
}

void write_overlay(Device& device, std::uint32_t x8, std::uint32_t y, std::span<const std::uint8_t> bits) {
  std::memcpy(&device.overlay[y * (screen_width / 8) + x8], bits.data(), bits.size());
}

void fill_overlay(Device& device, const Rectangle& area, bool value) {
  for (std::uint32_t y = area.y; y < std::uint32_t{area.y} + area.height; ++y) {
    for (std::uint32_t x = area.x; x < std::uint32_t{area.x} + area.width; ++x) {
      std::uint8_t& byte = device.overlay[y * (screen_width / 8) + x / 8];
      const auto bit = static_cast<std::uint8_t>(0x80U >> x % 8);
      byte = merge(byte, value ? 0xFF : 0, bit);
    }
  }
}

} // namespace halftone::device
