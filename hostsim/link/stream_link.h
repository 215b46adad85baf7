#pragma once

#include <halftone/link/link.h>

#include <chrono>
#include <memory>
#include <string>

namespace halftone::link {

/// One way: the bytes of the commands, as they are, into a new file, or a regular one that is written over.
/// Throws DeviceError where it cannot be.
std::unique_ptr<Link> open_file_link(const std::string& path, std::chrono::milliseconds timeout);

/// One way: into standard output, which must not be a terminal (DeviceError). A reader that has gone is a
/// DeviceError as well, and no signal; one that takes nothing for `timeout` is a Timeout.
std::unique_ptr<Link> open_pipe_link(std::chrono::milliseconds timeout);

} // namespace halftone::link
