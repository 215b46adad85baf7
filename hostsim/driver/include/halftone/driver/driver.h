#pragma once
// The host's side of the frame buffer: finished rows become commands, and the picture comes back from the
// device. The only way from the engine to a PNG.

#include <halftone/link/link.h>

#include <cstdint>
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
Placement centred(int width, int height);

class Driver {
public:
  /// The link must outlive the driver. Throws link::DeviceError or link::Timeout, as all calls here do.
  explicit Driver(link::Link& link);

  /// Identifies the device, clears the screen to black and opens the window that rows are sent to.
  void begin(int width, int height);

  /// Sends row y (from the top of the picture) of 3 * width bytes.
  void send_row(int y, std::span<const std::uint8_t> rgb);

  /// Waits for the device, checks its error status, and verifies by checksum that it holds what was sent,
  /// sending again what differs. Throws link::DeviceError that names what is missing.
  void finish();

  /// The picture (3 * width * height) as read back from the device.
  std::vector<std::uint8_t> read_picture();

  /// The whole 512 x 512 screen as shown.
  std::vector<std::uint8_t> read_screen();

  /// Seconds spent in the calls above, monotonic clock.
  double seconds() const;

private:
  link::Link& link_;
};

} // namespace halftone::driver
