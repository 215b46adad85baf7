#pragma once
// Who painted a pixel.

#include <halftone/inspect/memory.h>
#include <halftone/inspect/reference.h>

#include <halftone/recording/trace.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace halftone::inspect {

inline constexpr std::uint64_t to_the_end = std::numeric_limits<std::uint64_t>::max();

/// The device after the command of this number, or after the last.
device::Device device_after(const recording::Trace& trace, std::uint64_t until = to_the_end);

/// A command that addressed the pixel, whether its value changed or not.
struct Write {
  Reference command;
  device::Pixel before{};
  device::Pixel after{};
  bool masked_out = false; ///< the write mask let no bit through: the command did not write

  bool operator==(const Write&) const = default;
};

struct Writers {
  std::optional<Write> last;  ///< the last that was not masked out
  std::vector<Write> newest;  ///< all of them, newest first, at most as many as asked for
  std::uint64_t writes = 0;   ///< how many there were
  std::uint64_t commands = 0; ///< that were looked at
  device::Pixel start{};      ///< the pixel before the first command
  device::Pixel value{};      ///< after the last
};

/// The commands that addressed the pixel, up to the one of the number `until`.
Writers who(const recording::Trace& trace, const Place& place, std::size_t at_most,
            std::uint64_t until = to_the_end);

} // namespace halftone::inspect
