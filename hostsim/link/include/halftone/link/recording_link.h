#pragma once
// A link that keeps what is sent over it.

#include <halftone/link/link.h>

#include <halftone/device/device.h>
#include <halftone/protocol/decoder.h>
#include <halftone/recording/write.h>

#include <chrono>
#include <exception>
#include <memory>
#include <span>
#include <string_view>

namespace halftone::link {

/// Over another link, as one session. What is sent is recorded before it is sent. The other side is not asked
/// what it has come to: the states in the recording are those of a device that gets all of it, from power-on.
/// Where something cannot be recorded it is not sent, and nothing is after it: send throws the same again.
class RecordingLink final : public Link {
public:
  /// Begins the session. The recording, of a device as at power-on, must outlive the link.
  RecordingLink(std::unique_ptr<Link> over, recording::Writer& recording, std::string_view peer);

  void send(std::span<const std::uint8_t> bytes) override;
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override;
  bool has_way_back() const override;
  void finish() override;
  void cut() override;

  /// Ends the session, and notes the state where all was recorded. Nothing is sent after it.
  void end(std::string_view how);

private:
  void record(std::span<const std::uint8_t> bytes);

  std::unique_ptr<Link> over_;
  recording::Writer& recording_;
  device::Device device_;
  protocol::Decoder decoder_{protocol::Direction::to_device};
  std::exception_ptr failure_; ///< of the recording
};

} // namespace halftone::link
