#pragma once
// What a client says to the device and what the device says to it, whatever the bytes travel over.

#include <halftone/device/device.h>
#include <halftone/protocol/decoder.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace halftone::serve {

/// Hears the bytes that reached the device, in the order in which it took them.
using Record = std::function<void(std::span<const std::uint8_t> bytes)>;

/// Replies that wait for the client before the device stops: with the answer to one more command, of less
/// than a megabyte, this bounds the memory of a session, whatever its client does.
inline constexpr std::size_t waiting_limit = std::size_t{1} << 20;

/// One client, with a decoder of its own, so that the rest of a command which another client did not finish
/// is no part of its stream.
class Session {
public:
  /// The device must outlive the session. `record` may be empty.
  Session(device::Device& device, Record record);

  /// Whether take may be called: all that was taken before is executed.
  bool is_ready() const { return input_.size() == executed_; }

  /// Executes commands until their replies reach waiting_limit, and the rest as the replies are sent.
  void take(std::span<const std::uint8_t> bytes);

  /// The client sends no more: what it began and did not finish is damage. Once everything is executed.
  void end_of_input();

  /// The device goes off and on; what it had received and not executed is lost, as are its replies.
  void restart();

  /// For the client, in order.
  std::span<const std::uint8_t> replies() const;

  /// So many bytes of them are with the client.
  void replied(std::size_t count);

private:
  void execute();

  device::Device& device_;
  Record record_;
  protocol::Decoder decoder_{protocol::Direction::to_device};
  std::vector<std::uint8_t> input_;
  std::size_t executed_ = 0; ///< bytes of the input
  std::vector<std::uint8_t> replies_;
  std::size_t replied_ = 0; ///< bytes of the replies
};

} // namespace halftone::serve
