#pragma once
// The device's front panel: what a person asks for, as commands of the protocol.

#include <halftone/device/device.h>
#include <halftone/display/event.h>

namespace halftone::watch {

/// The bytes of the commands that do it to a device with these registers; empty for what is no matter of the
/// device.
device::Bytes commands_for(const display::Event& event, const device::Registers& registers);

} // namespace halftone::watch
