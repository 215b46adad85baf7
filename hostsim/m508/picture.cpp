#include "picture.h"

#include <halftone/device/screen.h>

namespace halftone::m508 {

namespace {

device::Bytes looked_up(const device::Device& device) {
  device::Bytes pixels = device.images[device.registers.shown];
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t channel = i % protocol::channels;
    pixels[i] = device.luts[channel][pixels[i] & device.registers.read_mask[channel]];
  }
  return pixels;
}

} // namespace

png::Picture picture_of(const device::Device& device, View view) {
  png::Picture picture{protocol::screen_width, protocol::screen_height, {}};
  switch (view) {
  case View::raw:
    picture.rgb = device.images[device.registers.shown];
    break;
  case View::lut:
    picture.rgb = looked_up(device);
    break;
  case View::shown:
    picture.rgb = device::screen(device);
    break;
  }
  return picture;
}

} // namespace halftone::m508
