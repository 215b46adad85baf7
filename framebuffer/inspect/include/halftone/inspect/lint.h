#pragma once
// What a driver's author would want to be told about a stream that the device accepts.

#include <halftone/inspect/reference.h>

#include <halftone/recording/trace.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::inspect {

enum class Kind {
  rejected,
  masked_out,
  never_seen,
  wraps,
  outside_window,
  window_unused,
  partly_unseen,
  redundant
};

/// A warning is most likely a mistake; a note may be meant so, and costs time at most.
enum class Severity { warning, note };

struct KindEntry {
  Kind kind;
  std::string_view name;
  Severity severity;
  std::string_view meaning;
};

/// In the order of Kind.
///
/// Seen is what was in the shown buffer, and in the part of it that pan and zoom show, while a field of the
/// virtual clock ended without blank, which every wait makes sure of; what was in either buffer when the
/// shown one was changed; and what was read back, summed up by checksum or copied from. Of the overlay: what
/// was in it while a field ended and it was on, blinking or not, or what was read back.
inline constexpr std::array kind_table{
    KindEntry{Kind::rejected, "rejected", Severity::warning, "the device refused the command"},
    KindEntry{Kind::masked_out, "masked-out", Severity::warning,
              "a write while the write mask lets no bit through"},
    KindEntry{Kind::never_seen, "never-seen", Severity::warning,
              "all pixels of a write were overwritten before any was seen"},
    KindEntry{Kind::wraps, "wraps", Severity::warning,
              "pixels beyond the end of the window, which go on at its beginning"},
    KindEntry{Kind::outside_window, "outside-window", Severity::warning,
              "a fill or copy of a rectangle that lies partly in the window and partly not; one that lies "
              "wholly outside is taken for meant"},
    KindEntry{Kind::window_unused, "window-unused", Severity::warning,
              "a window into which nothing was written"},
    KindEntry{Kind::partly_unseen, "partly-unseen", Severity::note,
              "some pixels of a write, other than clear or reset, were overwritten before they were seen"},
    KindEntry{Kind::redundant, "redundant", Severity::note,
              "a command, other than reset and wait, that changed nothing"},
};

constexpr const KindEntry& entry_of(Kind kind) { return kind_table[static_cast<std::size_t>(kind)]; }

struct Finding {
  Kind kind = Kind::rejected;
  Reference command;
  std::string what;
  std::string advice;
};

/// In the order of the commands, and of kinds where a command has several.
std::vector<Finding> lint(const recording::Trace& trace);

} // namespace halftone::inspect
