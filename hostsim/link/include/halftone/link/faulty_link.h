#pragma once
// A link that fails, the same way for the same seed: to try hosts on.

#include <halftone/link/faults.h>
#include <halftone/link/link.h>

#include <functional>
#include <memory>

namespace halftone::link {

using Opening = std::function<std::unique_ptr<Link>()>;

/// Over the link that `open` gives. When the device restarts it is opened anew: a device in memory has then
/// forgotten everything.
std::unique_ptr<Link> open_faulty_link(const Faults& faults, const Opening& open);

} // namespace halftone::link
