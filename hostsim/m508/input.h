#pragma once
// What the commands read, and where they must not write.

#include <halftone/device/clock.h>
#include <halftone/recording/trace.h>
#include <halftone/terminal/output_file.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace halftone::m508 {

/// What is no regular file, such as a pipe, does not say how long it is: more bytes than these are refused.
inline constexpr std::size_t stream_limit = std::size_t{256} << 20;

/// A file, "-" for standard input; of what is no regular file up to stream_limit bytes. A named pipe that
/// nobody writes to is waited for, as by any program. Throws core::InputError.
std::string read_text(const std::string& file);

/// A recording or a raw stream. Says on stderr where it was cut off.
recording::Trace read_trace(const std::string& file);

/// A table of buses from a file; the built-in ones where its name is empty. Throws core::InputError.
std::vector<device::Bus> read_buses(const std::string& file);

/// Where an input is, without links; empty where it is nowhere.
std::filesystem::path path_of(const std::string& input);

/// terminal::check_outputs; an input called "-" is standard input, of which there is one (ArgumentError).
void check_files(const std::vector<terminal::Output>& outputs, const std::vector<std::string>& inputs);

} // namespace halftone::m508
