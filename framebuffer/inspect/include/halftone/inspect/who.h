#pragma once
// Who painted a pixel.

#include <halftone/inspect/memory.h>
#include <halftone/inspect/reference.h>

#include <halftone/recording/trace.h>
#include <halftone/recording/walk.h>

#include <chrono>
#include <cstddef>
#include <deque>
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

/// Looks for the commands that addressed a pixel, and goes on where more of the stream is asked about.
class Search {
public:
  using Time = std::chrono::steady_clock::time_point;

  /// The trace has to outlive the search, and may grow. Keeps the newest commands, at most so many.
  Search(const recording::Trace& trace, const Place& place, std::size_t at_most);

  /// On to the command of the number `until`, or to the end of a trace that has one; not back. After the
  /// deadline no further than one command: whether it is there.
  bool go_on(std::uint64_t until, Time deadline = Time::max());

  Writers writers() const;

private:
  void look_at(const recording::Step& step);

  recording::Walk walk_;
  Place place_;
  std::size_t at_most_;
  Sections sections_;
  Writers found_; ///< without the newest
  std::deque<Write> newest_;
};

/// The commands that addressed the pixel, up to the one of the number `until`.
Writers who(const recording::Trace& trace, const Place& place, std::size_t at_most,
            std::uint64_t until = to_the_end);

} // namespace halftone::inspect
