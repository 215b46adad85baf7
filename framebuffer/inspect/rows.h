#pragma once
// The bytes of memory that a command writes to.

#include <halftone/device/addressed.h>

#include <span>

namespace halftone::inspect {

/// Row y of the screen within a region that it crosses; of the overlay, the bytes that its bits lie in.
std::span<const std::uint8_t> row_of(const device::Device& device, const device::Region& region,
                                     std::size_t y);

} // namespace halftone::inspect
