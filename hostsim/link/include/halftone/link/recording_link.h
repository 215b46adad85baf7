#pragma once
// A link that keeps what is sent over it.

#include <halftone/link/link.h>
#include <halftone/recording/write.h>

#include <memory>

namespace halftone::link {

/// Over the other link. What is sent is recorded before it is sent. The recording must outlive the link.
std::unique_ptr<Link> open_recording_link(std::unique_ptr<Link> over, recording::Writer& recording);

} // namespace halftone::link
