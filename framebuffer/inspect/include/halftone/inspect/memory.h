#pragma once
// Single pixels of the device's memory.

#include <halftone/device/addressed.h>
#include <halftone/device/device.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace halftone::inspect {

/// Of the channels, as in commands and files.
inline constexpr std::array<std::string_view, protocol::channels> channel_names{"red", "green", "blue"};

/// Column and row from 0 to 511.
struct Place {
  device::Plane plane = device::Plane::image_0;
  std::uint16_t x = 0;
  std::uint16_t y = 0;

  bool operator==(const Place&) const = default;
};

/// As in commands and files: image0, image1, overlay.
std::string_view name_of(device::Plane plane);

/// A pixel's value; of the overlay {0, 0, 0} or {1, 1, 1}.
device::Pixel value_at(const device::Device& device, const Place& place);

/// As in "255 128 0"; of the overlay "0" or "1".
std::string text_of(device::Plane plane, const device::Pixel& value);

constexpr bool holds(const device::Rectangle& area, std::uint32_t x, std::uint32_t y) {
  return x >= area.x && y >= area.y && x - area.x < area.width && y - area.y < area.height;
}

} // namespace halftone::inspect
