#pragma once
// What the commands read, and where they must not write.

#include <halftone/recording/trace.h>

#include <cstddef>
#include <string>

namespace halftone::m508 {

/// What is no regular file, such as a pipe, does not say how long it is: more bytes than these are refused.
inline constexpr std::size_t stream_limit = std::size_t{256} << 20;

/// A file, "-" for standard input; of what is no regular file up to stream_limit bytes. A named pipe that
/// nobody writes to is waited for, as by any program. Throws core::InputError.
std::string read_text(const std::string& file);

/// A recording or a raw stream. Says on stderr where it was cut off.
recording::Trace read_trace(const std::string& file);

/// terminal::check_writable, and ArgumentError where the output, the file of this option, would be written
/// over the input.
void check_output(const std::string& option, const std::string& output, const std::string& input);

} // namespace halftone::m508
