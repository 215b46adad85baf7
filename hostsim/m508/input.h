#pragma once
// What the commands read, and where they must not write.

#include <halftone/recording/trace.h>

#include <string>

namespace halftone::m508 {

/// A file, "-" for standard input. Throws core::InputError.
std::string read_text(const std::string& file);

/// A recording or a raw stream. Says on stderr where it was cut off.
recording::Trace read_trace(const std::string& file);

/// terminal::check_writable, and ArgumentError where the output would be written over the input.
void check_output(const std::string& output, const std::string& input);

} // namespace halftone::m508
