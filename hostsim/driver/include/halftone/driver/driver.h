#pragma once
// The host's side of the frame buffer: finished rows become commands, and the picture comes back from the
// device. The only way from the engine to a PNG.
//
// What the link damages or loses is found by checksums and sent or asked for again, a bounded number of
// times: each call ends with what it promises or with an exception. On a link without a way back nothing can
// be asked: the commands are sent, and the driver knows no more than that.

#include <halftone/link/link.h>
#include <halftone/protocol/opcodes.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace halftone::driver {

/// Where a picture of width x height sits on the 512 x 512 screen: centred, rounded down.
struct Placement {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

/// Width and height from 1 to 512.
Placement centred(int width, int height);

/// How many times the timeout begin, finish, read_picture and read_screen wait for answers at most, each,
/// with everything that they send and ask again: a link that loses much must not keep its host for hours.
inline constexpr int step_limit = 10;

class Conversation;

class Driver {
public:
  /// The link must outlive the driver. A device that gives no usable answer for `timeout` has failed, as has
  /// one whose answers in a call come to step_limit times as much. Throws link::DeviceError or link::Timeout,
  /// as all calls here do; when the link fails they name the rows of the picture that may be missing on the
  /// device, or were not read back.
  explicit Driver(link::Link& link, std::chrono::milliseconds timeout = std::chrono::seconds(10));
  ~Driver();

  /// Identifies the device, clears the screen to black and opens the window that rows are sent to. Width and
  /// height from 1 to 512.
  void begin(int width, int height);

  /// Sends row y (from the top of the picture) of 3 * width bytes. Rows may come in any order; in ascending
  /// order they need the fewest bytes.
  void send_row(int y, std::span<const std::uint8_t> rgb);

  /// Whether this is what was sent as row y last, or the black of the beginning: it need not be sent again.
  bool holds(int y, std::span<const std::uint8_t> rgb) const;

  /// Waits for the device, checks its error status, and verifies by checksum that the whole screen holds what
  /// was sent, sending again the rows that differ. Throws link::DeviceError that names what is missing.
  void finish();

  /// The picture (3 * width * height) as read back from the device; what a device no longer holds, as after a
  /// restart, is sent again. Throws link::DeviceError that names the rows that still are not what was sent.
  /// Needs a way back.
  std::vector<std::uint8_t> read_picture();

  /// The whole 512 x 512 screen as shown, in the same way.
  std::vector<std::uint8_t> read_screen();

  /// The same screen where somebody at the device's panel may have made something else of it, by pan, zoom or
  /// tables: as it is, with nothing to hold it against but the checksums of its own way here.
  std::vector<std::uint8_t> read_shown();

  /// Seconds spent in the calls above, monotonic clock.
  double seconds() const;

private:
  void verify();
  std::vector<std::uint8_t> read(protocol::Opcode query, const Placement& area);
  std::vector<int> differing_rows(std::span<const std::uint8_t> rgb, const Placement& area) const;

  std::unique_ptr<Conversation> conversation_;
  bool has_way_back_;
  Placement picture_;
  std::vector<std::uint8_t> screen_; ///< what the device's screen should hold
  std::vector<bool> verified_;       ///< rows of the screen that the device was seen to hold
  int next_row_ = 0;                 ///< of the picture: where the device's writing position is
  double seconds_ = 0;
};

} // namespace halftone::driver
