#pragma once
// Byte streams between host and device.

#include <halftone/link/address.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace halftone::link {

/// The device or the link failed, or the device reported an error.
class DeviceError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// No answer within the time given.
class Timeout : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Link {
public:
  virtual ~Link() = default;

  /// Sends all bytes, or throws.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;

  /// Receives between 1 and bytes.size() bytes; returns how many. Throws Timeout when none came in time,
  /// DeviceError when the other side has closed.
  virtual std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) = 0;

  /// Whether anything can ever be received. If not, receive throws DeviceError.
  virtual bool has_way_back() const { return true; }

  /// Everything has been sent. Where the device is a file, it is written now and not before, and finish
  /// throws file::WriteError where it cannot be.
  virtual void finish() {}

  /// The end, from any thread: those who send or receive, and who come later, are given DeviceError at once.
  /// Nothing for links on which nobody waits.
  virtual void cut() {}
};

/// Connects, within `timeout`; later a send that gets no byte away for as long is a Timeout. Throws
/// DeviceError where it cannot be opened, file::WriteError where it is a file, Timeout.
std::unique_ptr<Link> open(const Address& address,
                           std::chrono::milliseconds timeout = std::chrono::seconds(10));

/// The same for an address in words; throws std::invalid_argument with advice for one that is not understood.
std::unique_ptr<Link> open(const std::string& address,
                           std::chrono::milliseconds timeout = std::chrono::seconds(10));

} // namespace halftone::link
