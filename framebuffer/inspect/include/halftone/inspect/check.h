#pragma once
// Expectations of a recording, and whether they hold.

#include <halftone/inspect/settings.h>

#include <halftone/device/device.h>
#include <halftone/png/png.h>
#include <halftone/recording/trace.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace halftone::inspect {

/// When a check looks at the device: after a command of this number, after the first mark of this name, or at
/// the end.
struct AtEnd {};
using Moment = std::variant<AtEnd, std::uint64_t, std::string>;

/// The screen as shown, or a plane of memory.
enum class Surface { screen, image_0, image_1, overlay };

/// All pixels of a rectangle have this colour; of the overlay, {0, 0, 0} or {1, 1, 1}.
struct ColorCheck {
  Surface surface = Surface::screen;
  device::Rectangle area;
  device::Pixel color{};
};

/// CRC-32 of a rectangle's bytes in row order; of the overlay, a byte a pixel, 0 or 1.
struct ChecksumCheck {
  Surface surface = Surface::screen;
  device::Rectangle area;
  std::uint32_t checksum = 0;
};

/// A rectangle and a picture of its size are no farther apart than this, in 8-bit levels.
struct ImageCheck {
  Surface surface = Surface::screen;
  device::Rectangle area;
  png::Picture picture;
  std::optional<double> max_difference; ///< of any channel
  std::optional<double> max_rmse;
  std::optional<double> differing; ///< share of pixels that may differ at all, 0 to 1
};

/// Registers of settings.h have these values.
struct SettingsCheck {
  std::vector<std::pair<std::string, std::vector<std::uint32_t>>> settings;
};

/// So many of these came by then: opcodes by name, and "commands" (all, rejected ones too), "queries" and
/// "errors" (rejected ones).
struct CountsCheck {
  std::vector<std::pair<std::string, std::uint64_t>> counts;
};

/// Entries of a look-up table from `first` on.
struct LutCheck {
  std::size_t channel = 0; ///< 0 red, 1 green, 2 blue
  std::size_t first = 0;   ///< first + values.size() <= 256
  std::vector<std::uint8_t> values;
};

struct Check {
  std::string name;
  Moment at;
  std::variant<ColorCheck, ChecksumCheck, ImageCheck, SettingsCheck, CountsCheck, LutCheck> expectation;
};

struct Verdict {
  bool holds = false;
  std::optional<std::uint64_t> number;    ///< of commands executed when it was looked at; nothing: never
  std::string message;                    ///< what was found and expected, where; empty if it holds
  std::optional<png::Picture> difference; ///< of an image that does not hold
};

/// A verdict for each check, in their order. Pictures of images must have the size of their area.
std::vector<Verdict> evaluate(const recording::Trace& trace, const std::vector<Check>& checks);

/// Whether there are such registers, and of how many numbers; nothing if there are none of the name.
std::optional<std::size_t> numbers_of_setting(std::string_view name);

/// Whether something of this name is counted.
bool is_counted(std::string_view name);

} // namespace halftone::inspect
