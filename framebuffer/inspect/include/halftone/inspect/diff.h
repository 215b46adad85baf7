#pragma once
// Where two recordings part.

#include <halftone/inspect/reference.h>

#include <halftone/recording/trace.h>

#include <optional>
#include <string>
#include <vector>

namespace halftone::inspect {

/// Something in which two devices differ.
struct Difference {
  enum class Part { pixels, lut, cursor_pattern, setting, clock };

  Part part = Part::pixels;
  std::string name;    ///< image0, image1, overlay; red, green, blue; cursor_pattern; a setting; clock
  std::uint32_t x = 0; ///< column of the first pixel in reading order that differs, or index of the entry
  std::uint32_t y = 0; ///< row of the pixel
  std::string a;       ///< the values there
  std::string b;
  std::uint64_t count = 1;              ///< pixels or entries of this name that differ
  device::Rectangle bounds{0, 0, 1, 1}; ///< of those pixels

  bool operator==(const Difference&) const = default;
};

struct Comparison {
  bool ignore_clock = false; ///< nor commands that do nothing but wait
};

/// All differences of two devices: memory, tables, settings without the count of commands, clock.
std::vector<Difference> differences(const device::Device& a, const device::Device& b,
                                    const Comparison& comparison);

/// The commands after which the devices differ for the first time.
struct Parting {
  std::uint64_t step = 0;     ///< how many pairs of commands were executed; 0: they began differently
  std::optional<Reference> a; ///< nothing where they began differently or this recording has ended
  std::optional<Reference> b;
  std::vector<Difference> differences;
};

/// Executes both recordings in step, command by command; queries and marks are left out. After the end of the
/// shorter one its device stands still. Nothing if the devices never differ.
std::optional<Parting> diff(const recording::Trace& a, const recording::Trace& b,
                            const Comparison& comparison);

} // namespace halftone::inspect
