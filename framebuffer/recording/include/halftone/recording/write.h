#pragma once
// From values to the bytes of a recording.

#include <halftone/recording/trace.h>

#include <halftone/protocol/decoder.h>

#include <cstdint>
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

/// A writer notes the state after every mark, and after a command with which so many bytes of commands,
/// damage among them, have been executed since it was noted last. It takes as long as the checksum of 1.6 MB.
inline constexpr std::uint64_t state_interval = std::uint64_t{1} << 20;

/// Writes a recording while it happens.
class Writer {
public:
  /// Takes a header or some whole records at a call, so that a file that is written through is readable after
  /// every call. May throw, and has then taken nothing; a session may be ended after that, and nothing else
  /// written.
  using Sink = std::function<void(std::span<const std::uint8_t>)>;

  /// Writes the header of a recording that begins with this device, as it is now.
  Writer(Sink sink, const device::Device& device);

  void begin_session(std::string_view peer);
  /// To be called before the device executes them, so that a command that ends the device is in the trace.
  void data(std::span<const std::uint8_t> bytes);
  void end_session(std::string_view how);
  /// Between sessions.
  void restart();
  /// To be called with every item, rejections too, after the device has executed it; notes the state where
  /// that is due.
  void executed(const protocol::Item& item, const device::Device& device);
  /// Notes the state after all items executed so far.
  void state(const device::Device& device);

private:
  Sink sink_;
  std::uint64_t commands_ = 0; ///< as in State::commands
  std::uint64_t bytes_ = 0;    ///< of items executed since the state was noted last
};

} // namespace halftone::recording
