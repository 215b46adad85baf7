#pragma once
// What a client says to the device and what the device says to it, whatever the bytes travel over.

#include <halftone/device/device.h>
#include <halftone/protocol/decoder.h>
#include <halftone/recording/write.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::serve {

/// Bytes of replies that wait for the client before the device stops: with the answer to one more command, of
/// less than a megabyte, this bounds the memory of a session, whatever its client does.
inline constexpr std::size_t waiting_limit = std::size_t{1} << 20;

/// One client, with a decoder of its own, so that the rest of a command which another client did not finish
/// is no part of its stream.
class Session {
public:
  /// `peer` is who the client is, in words. Device and recording must outlive the session; the recording may
  /// be null. The recorded session begins with the first byte: whoever sends none is no client.
  Session(device::Device& device, recording::Writer* recording, std::string peer);

  /// Whether take may be called: all that was taken before is executed.
  bool is_ready() const { return input_.size() == executed_; }

  /// Executes commands until their replies reach waiting_limit, and the rest as the replies are sent.
  void take(std::span<const std::uint8_t> bytes);

  /// Bytes that the client has to send before anybody else may speak to the device: it is in the midst of a
  /// command.
  std::size_t missing() const { return decoder_.missing(); }

  /// Whether somebody else may speak now: nothing of the client is halfway, neither a command nor an answer.
  bool is_interruptible() const { return is_ready() && missing() == 0; }

  /// Somebody else speaks: whole commands without replies, recorded as a session of theirs. While
  /// is_interruptible().
  void interrupt(std::span<const std::uint8_t> commands, std::string_view who);

  /// The client does not listen any more: all that was taken is executed, and from now on whatever is,
  /// without making replies.
  void stop_answering();

  /// The client sends no more, or is not heard any more: all that was taken is executed, and what it began
  /// and did not finish is damage. `how` it ended is told to the recording. Once.
  void end(std::string_view how);

  /// The device goes off and on: it is as after `reset`, and counts that as an item. What the client began
  /// and did not finish is damage, and replies that wait are lost.
  void restart();

  /// For the client, in order.
  std::span<const std::uint8_t> replies() const;

  /// So many bytes of them are with the client.
  void replied(std::size_t count);

private:
  void execute();
  void execute(const protocol::Item& item);

  device::Device& device_;
  recording::Writer* recording_;
  std::string peer_;
  bool is_begun_ = false; ///< in the recording
  bool is_deaf_ = false;  ///< the client, to replies
  protocol::Decoder decoder_{protocol::Direction::to_device};
  std::vector<std::uint8_t> input_;
  std::size_t executed_ = 0; ///< bytes of the input
  std::vector<std::uint8_t> replies_;
  std::size_t replied_ = 0; ///< bytes of the replies
};

} // namespace halftone::serve
