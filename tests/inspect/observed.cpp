#include "observed.h"

#include <halftone/inspect/memory.h>

#include <random>

namespace halftone::test {

namespace {

using device::Device;

constexpr std::array planes{device::Plane::image_0, device::Plane::image_1, device::Plane::overlay};

/// All bits inverted: a command that sets a value changes this memory or the other.
Device inverted(Device device) {
  for (device::Bytes& image : device.images)
    for (std::uint8_t& byte : image) byte = static_cast<std::uint8_t>(~byte);
  for (std::uint8_t& byte : device.overlay) byte = static_cast<std::uint8_t>(~byte);
  return device;
}

/// No pixel is the same as any other, so that a copy shows.
Device distinct(Device device) {
  for (std::size_t image = 0; image < 2; ++image) {
    for (std::size_t i = 0; i < device.images[image].size() / 3; ++i) {
      device.images[image][3 * i] = static_cast<std::uint8_t>(i >> 16 | image << 7);
      device.images[image][3 * i + 1] = static_cast<std::uint8_t>(i >> 8);
      device.images[image][3 * i + 2] = static_cast<std::uint8_t>(i);
    }
  }
  return device;
}

void watch(Device& device, const protocol::Item& item, Written& written) {
  const Device before = device;
  device::Bytes replies;
  device.execute(item, replies);
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    const bool is_overlay = planes[plane] == device::Plane::overlay;
    if (is_overlay ? before.overlay == device.overlay : before.images[plane] == device.images[plane])
      continue;
    for (std::size_t i = 0; i < written[plane].size(); ++i) {
      const inspect::Place place{planes[plane], static_cast<std::uint16_t>(i % 512),
                                 static_cast<std::uint16_t>(i / 512)};
      if (inspect::value_at(before, place) != inspect::value_at(device, place)) written[plane][i] = true;
    }
  }
}

} // namespace

Written execute_and_watch(Device& device, const protocol::Item& item) {
  Written written;
  for (auto& plane : written) plane.resize(std::size_t{512} * 512);
  Device other = inverted(device), third = distinct(device);
  watch(other, item, written);
  watch(third, item, written);
  watch(device, item, written);
  return written;
}

} // namespace halftone::test
