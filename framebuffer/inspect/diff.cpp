// Both devices are equal before every step, so only what its commands write to can differ after it: regions
// of memory by device::addressed, and the small rest, which is compared whole.

#include <halftone/inspect/diff.h>

#include "rows.h"

#include <halftone/device/addressed.h>

#include <halftone/recording/walk.h>

#include <algorithm>
#include <utility>

namespace halftone::inspect {

namespace {

using device::Device;
using device::Region;
using protocol::Opcode;

/// One of the two recordings.
struct Side {
  explicit Side(const recording::Trace& trace) : walk(trace) {}

  recording::Walk walk;
  Sections sections;
  std::optional<recording::Step> step; ///< nothing at the end
  std::vector<Region> touched;         ///< by the step
};

bool is_compared(const recording::Step& step, const Comparison& comparison) {
  const protocol::Message* message = message_of(step);
  if (message == nullptr) return true; // it sets the error status
  if (is_query(*message) || message->opcode == Opcode::mark) return false;
  return message->opcode != Opcode::wait || !comparison.ignore_clock;
}

/// To the next command that is compared, and executes it.
void advance(Side& side, const Comparison& comparison) {
  side.touched.clear();
  do {
    side.step = side.walk.next();
    if (!side.step) return;
    side.sections.follow(*side.step);
  } while (!is_compared(*side.step, comparison));
  if (const protocol::Message* message = message_of(*side.step))
    side.touched = device::addressed(side.walk.device().registers, *message);
}

bool are_equal(const Device& a, const Device& b, const Region& region) {
  for (std::size_t y = region.area.y; y < std::size_t{region.area.y} + region.area.height; ++y)
    if (!std::ranges::equal(row_of(a, region, y), row_of(b, region, y))) return false;
  return true;
}

bool registers_are_equal(device::Registers a, const device::Registers& b) {
  a.commands = b.commands; // counts marks, too
  return a == b;
}

bool are_equal_after(const Side& a, const Side& b, const Comparison& comparison) {
  const Device &of_a = a.walk.device(), &of_b = b.walk.device();
  const auto is_same = [&](const Region& region) { return are_equal(of_a, of_b, region); };
  return registers_are_equal(of_a.registers, of_b.registers) && of_a.luts == of_b.luts &&
         of_a.cursor_pattern == of_b.cursor_pattern &&
         (comparison.ignore_clock || of_a.clock.picoseconds == of_b.clock.picoseconds) &&
         std::ranges::all_of(a.touched, is_same) && std::ranges::all_of(b.touched, is_same);
}

std::optional<Reference> reference_to(const Side& side) {
  if (!side.step) return std::nullopt;
  return side.sections.refer_to(*side.step);
}

} // namespace

std::optional<Parting> diff(const recording::Trace& trace_a, const recording::Trace& trace_b,
                            const Comparison& comparison) {
  Side a(trace_a), b(trace_b);
  std::vector<Difference> found = differences(a.walk.device(), b.walk.device(), comparison);
  if (!found.empty()) return Parting{0, {}, {}, std::move(found)};
  for (std::uint64_t step = 1;; ++step) {
    advance(a, comparison);
    advance(b, comparison);
    a.walk.execute();
    b.walk.execute();
    if (!are_equal_after(a, b, comparison))
      return Parting{step, reference_to(a), reference_to(b),
                     differences(a.walk.device(), b.walk.device(), comparison)};
    if (!a.step && !b.step) return std::nullopt;
  }
}

} // namespace halftone::inspect
