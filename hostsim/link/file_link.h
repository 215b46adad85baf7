#pragma once

#include <halftone/link/link.h>

#include <memory>
#include <string>

namespace halftone::link {

/// One way: the bytes of the commands, as they are, into a file that is whole or as it was: they are kept
/// until finish. Throws file::WriteError where the file cannot be written, now and then.
std::unique_ptr<Link> open_file_link(const std::string& path);

} // namespace halftone::link
