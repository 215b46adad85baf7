#pragma once

#include <halftone/link/link.h>

#include <memory>

namespace halftone::link {

/// A link to a device of its own, which executes what is sent at once. Its only doors are send and receive.
std::unique_ptr<Link> open_memory_link();

} // namespace halftone::link
