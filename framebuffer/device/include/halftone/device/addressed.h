#pragma once
// Which parts of the device's memory a command writes to.

#include <halftone/device/device.h>

namespace halftone::device {

/// Of the commands whose layout begins with one.
Rectangle rectangle_of(const protocol::Message& command);

enum class Plane : std::uint8_t { image_0, image_1, overlay };

struct Region {
  Plane plane = Plane::image_0;
  Rectangle area;

  bool operator==(const Region&) const = default;
};

/// What the command will write to when a device with these registers executes it, whether the bits change or
/// not: regions in which every pixel is addressed, and none outside them is. They may overlap where pixels
/// wrap around in a small window. Empty for commands that write to no memory.
std::vector<Region> addressed(const Registers& registers, const protocol::Message& command);

} // namespace halftone::device
