#pragma once
// From values to the bytes of a recording.

#include <halftone/recording/trace.h>

#include <functional>
#include <span>
#include <string_view>

namespace halftone::recording {

/// The bytes with which a file begins.
Bytes encode(const Header& header);

/// The bytes of a record, whose payload must be within record_limit.
Bytes encode(const Record& record);

/// The whole file that read() makes the trace of.
Bytes encode(const Trace& trace);

/// Writes a recording while it happens.
class Writer {
public:
  /// Takes a header or some whole records at a call, so that a file that is written through is readable after
  /// every call. May throw; the writer is then not to be used again.
  using Sink = std::function<void(std::span<const std::uint8_t>)>;

  /// Writes the header of a recording that begins with this device, as it is now.
  Writer(Sink sink, const device::Device& device);

  void begin_session(std::string_view peer);
  /// To be called before the device executes them, so that a command that ends the device is in the trace.
  void data(std::span<const std::uint8_t> bytes);
  void end_session(std::string_view how);
  /// Between sessions.
  void restart();
  /// `commands` as in State::commands: items, rejections too, since the recording began.
  void state(std::uint64_t commands, const device::Device& device);

private:
  Sink sink_;
};

} // namespace halftone::recording
