#pragma once

#include <halftone/file/descriptor.h>
#include <halftone/link/link.h>

#include <chrono>
#include <memory>

namespace halftone::link {

/// A link over a connected socket that does not block. A send that gets no byte away for `timeout` is a
/// Timeout.
std::unique_ptr<Link> open_socket_link(file::Descriptor socket, std::chrono::milliseconds timeout);

} // namespace halftone::link
