#pragma once
// Waiting for descriptors with a limit.

#include <halftone/file/descriptor.h>

#include <chrono>

namespace halftone::link {

/// Waits until one of the poll(2) events is there, an error and the other side's end among them; returns what
/// is. 0 when it is not there before the deadline. Throws DeviceError.
short wait_for(const file::Descriptor& descriptor, short events,
               std::chrono::steady_clock::time_point deadline);

} // namespace halftone::link
