#pragma once
// Pictures of a device.

#include <halftone/device/device.h>

#include <halftone/png/png.h>

namespace halftone::m508 {

enum class View {
  raw,  ///< the image buffer that is shown, as it is in memory
  lut,  ///< after read mask and look-up tables
  shown ///< as on the monitor: pan, zoom, overlay, cursor, border, blank too
};

png::Picture picture_of(const device::Device& device, View view);

} // namespace halftone::m508
