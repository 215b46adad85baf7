#pragma once
// From the bytes of a recording to values.

#include <halftone/recording/trace.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace halftone::recording {

/// A recording that cannot be read, or is damaged. what() is one line:
///   session.m508: byte 57: the checksum of this record is wrong; ...
class TraceError : public std::runtime_error {
public:
  TraceError(const std::string& file, std::size_t byte, const std::string& problem);
  /// Of the file as a whole.
  TraceError(const std::string& file, const std::string& problem);

  std::size_t offset = 0; ///< of the header or record that is damaged
};

/// Whether a file with this beginning is a recording; any other is a raw stream of commands.
bool is_recording(std::span<const std::uint8_t> file);

/// The recording, or the raw stream, in the bytes of a file whose name is used in messages alone. Throws
/// TraceError where a header or a whole record is damaged. A last record that is not whole is no damage, see
/// Trace::cut_off. Memory is bounded by the size of the file, and one device.
Trace read(std::span<const std::uint8_t> file, const std::string& name);

/// Whole records without a header, as a Writer hands them to its sink.
std::vector<Record> read_records(std::span<const std::uint8_t> bytes);

Trace read_file(const std::filesystem::path& file);

} // namespace halftone::recording
