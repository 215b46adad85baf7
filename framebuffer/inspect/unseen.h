#pragma once
// Which pixels hold what nobody has seen yet, and whose work is lost when they are overwritten.

#include <halftone/device/addressed.h>
#include <halftone/device/device.h>

#include <array>
#include <cstdint>
#include <vector>

namespace halftone::inspect {

/// A command that wrote pixels.
struct Work {
  std::uint64_t number = 0;
  device::Pixel mask{}; ///< bits that it wrote
  std::uint32_t pixels = 0;
  std::uint32_t lost = 0; ///< of them: overwritten before they were seen
  std::uint64_t by = 0;   ///< the command that overwrote the first of those
  bool erases = false;    ///< clear or reset
};

class Unseen {
public:
  /// The command has written to these regions, which may overlap. A write whose mask leaves some of the
  /// earlier bits alone makes nothing be lost.
  void write(Work work, const std::vector<device::Region>& regions);

  void see(device::Plane plane);
  void see(device::Plane plane, const device::Rectangle& area);
  /// What is on the screen of a device with these registers.
  void see_screen(const device::Registers& registers);

  /// All that wrote, in their order.
  const std::vector<Work>& works() const { return works_; }

private:
  using Writers =
      std::vector<std::uint32_t>; ///< of each pixel: 1 + index of the work, 0: seen or never written

  std::vector<Work> works_;
  std::array<Writers, 3> writers_{Writers(pixels), Writers(pixels), Writers(pixels)}; ///< by plane
  std::array<std::uint32_t, 3> seen_{}; ///< works up to this one are seen, besides

  static constexpr std::size_t pixels = std::size_t{protocol::screen_width} * protocol::screen_height;
};

} // namespace halftone::inspect
