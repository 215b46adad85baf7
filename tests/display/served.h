#pragma once
// m508 serve under the eyes of a display, and what its device says that it shows.

#include <halftone/device/device.h>
#include <halftone/link/link.h>

#include <string>
#include <vector>

namespace halftone::test {

/// Says so, in a warning, where a test cannot be made without programs, modules of displays as in "vnc", and
/// the Debian packages named that have them.
bool are_there(const std::vector<std::string>& programs, const std::vector<std::string>& modules,
               const std::string& packages);

/// Noise in both image buffers and in the overlay: no picture that is only alike equals it.
void send_noise(link::Link& link);

/// The whole screen, from a device that has no other client.
device::Bytes screen_of(link::Link& link);

/// What stands behind "display NAME on " in what was printed; empty if it does not come.
std::string address_in(const std::string& file, const std::string& display);

} // namespace halftone::test
