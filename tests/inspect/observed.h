#pragma once
// Which pixels a command writes, found by watching what happens to them: the slow twin of device::addressed.

#include <halftone/device/addressed.h>
#include <halftone/device/device.h>

#include <array>
#include <vector>

namespace halftone::test {

/// For each plane and pixel, whether it is written.
using Written = std::array<std::vector<bool>, 3>;

/// Executes the item on this device and on twins with other memory; a pixel that stays as it is on all of
/// them is not written. Bits that a mask protects are not written.
Written execute_and_watch(device::Device& device, const protocol::Item& item);

} // namespace halftone::test
