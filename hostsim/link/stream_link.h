#pragma once

#include <halftone/link/link.h>

#include <chrono>
#include <memory>

namespace halftone::link {

/// One way: into standard output, which must not be a terminal (DeviceError). A reader that has gone is a
/// DeviceError as well, and no signal; one that takes nothing for `timeout` is a Timeout.
std::unique_ptr<Link> open_pipe_link(std::chrono::milliseconds timeout);

} // namespace halftone::link
