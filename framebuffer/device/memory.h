#pragma once
// Writing to the image buffers and the overlay plane.

#include <halftone/device/device.h>

#include <span>

namespace halftone::device {

constexpr std::size_t offset_of(std::size_t x, std::size_t y) {
  return (y * protocol::screen_width + x) * protocol::channels;
}

/// A row of a rectangle of the written image.
std::span<const std::uint8_t> row_of(const Device& device, const Rectangle& rectangle, std::size_t row);

/// From the writing position on, under the write mask.
void write_pixels(Device& device, std::span<const std::uint8_t> pixels);
void write_color(Device& device, const Pixel& color, std::uint32_t count);

/// Under the write mask.
void fill(Device& device, const Rectangle& area, const Pixel& color);
void copy(Device& device, const Rectangle& area, std::uint16_t to_x, std::uint16_t to_y, std::uint8_t from);

void write_overlay(Device& device, std::uint32_t x8, std::uint32_t y, std::span<const std::uint8_t> bits);
void fill_overlay(Device& device, const Rectangle& area, bool value);

} // namespace halftone::device
