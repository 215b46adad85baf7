#pragma once
// What the device says to queries.

#include <halftone/device/device.h>

namespace halftone::device {

/// Appends the replies to a query to a stream; none to another command.
void answer(const protocol::Message& query, const Device& device, Bytes& replies);

} // namespace halftone::device
