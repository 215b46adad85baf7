#include <halftone/inspect/lint.h>

#include "explain.h"
#include "rows.h"
#include "unseen.h"

#include <halftone/device/clock.h>

#include <halftone/device/addressed.h>

#include <halftone/recording/walk.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace halftone::inspect {

namespace {

using device::Device;
using device::Plane;
using device::Rectangle;
using device::Region;
using device::Registers;
using protocol::index_of;
using protocol::Message;
using protocol::Opcode;

Plane image_plane(std::uint32_t buffer) { return buffer == 0 ? Plane::image_0 : Plane::image_1; }

bool goes_through_window(Opcode opcode) {
  return opcode == Opcode::pixels || opcode == Opcode::runs || opcode == Opcode::repeat;
}

bool erases(Opcode opcode) { return opcode == Opcode::clear || opcode == Opcode::reset; }

bool contains(const Rectangle& outer, const Rectangle& inner) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

bool meet(const Rectangle& a, const Rectangle& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// What of the state a command could have changed.
struct Before {
  Registers registers;
  std::array<device::Lut, protocol::channels> luts;
  std::array<std::uint8_t, 32> cursor_pattern;
  device::Bytes memory; ///< of the regions that it writes to

  bool operator==(const Before&) const = default;
};

void append_rows(const Device& device, const Region& region, device::Bytes& bytes) {
  for (std::size_t y = region.area.y; y < std::size_t{region.area.y} + region.area.height; ++y) {
    const auto row = row_of(device, region, y);
    bytes.insert(bytes.end(), row.begin(), row.end());
  }
}

Before state_of(const Device& device, const std::vector<Region>& regions) {
  Before state{device.registers, device.luts, device.cursor_pattern, {}};
  state.registers.commands = 0; // counts every command
  for (const Region& region : regions) append_rows(device, region, state.memory);
  return state;
}

class Linter {
public:
  explicit Linter(const recording::Trace& trace) : walk_(trace) {}

  std::vector<Finding> run() {
    while (const auto step = walk_.next()) {
      number_ = step->number;
      if (step->is_restart)
        restart();
      else if (const Message* message = message_of(*step))
        examine(*message);
      else
        reject(std::get<protocol::Rejection>(step->item.content));
    }
    end_window();
    add_lost_work();
    std::ranges::stable_sort(findings_, {}, [](const Finding& finding) {
      return std::tuple(finding.command.number, finding.kind);
    });
    return std::move(findings_);
  }

private:
  void reject(const protocol::Rejection& rejection) {
    Explanation explanation = explain(rejection);
    add(Kind::rejected, std::move(explanation.what), std::move(explanation.advice));
  }

  /// What it destroys, and what is done again after it, is no client's mistake.
  void restart() {
    window_.reset();
    for (const Plane plane : {Plane::image_0, Plane::image_1, Plane::overlay}) unseen_.see(plane);
    walk_.execute();
  }

  void examine(const Message& message) {
    const Registers& r = walk_.device().registers;
    examine_window(message, r);
    examine_rectangle(message, r);
    const bool is_lost = is_masked_out(r, message);
    if (is_lost)
      add(Kind::masked_out, "the write mask is 0 0 0: nothing is written",
          "set write_mask before writing, or leave the command out");
    see_used(message, r);
    execute(message, is_lost);
  }

  void examine_window(const Message& message, const Registers& r) {
    if (message.opcode == Opcode::window || message.opcode == Opcode::reset) end_window();
    if (message.opcode == Opcode::window) window_ = number_;
    if (!goes_through_window(message.opcode)) return;
    window_.reset();
    const std::uint32_t area = std::uint32_t{r.window.width} * r.window.height;
    const std::uint32_t position =
        (std::uint32_t{r.y} - r.window.y) * r.window.width + (std::uint32_t{r.x} - r.window.x);
    const std::uint32_t count = device::pixels_of(message), left = area - position;
    if (count > left)
      add(Kind::wraps,
          of_them(count - left, "pixel") + " of " + std::to_string(count) +
              " beyond the end of the window, which go on at its beginning",
          "the window " + text_of(r.window) + " had room for " + std::to_string(left) + " more");
  }

  void end_window() {
    if (!window_) return;
    findings_.push_back({Kind::window_unused,
                         {*window_},
                         "nothing is written into this window",
                         "leave it out; fill, copy and clear need no window"});
    window_.reset();
  }

  void examine_rectangle(const Message& message, const Registers& r) {
    if (message.opcode != Opcode::fill && message.opcode != Opcode::copy) return;
    const Rectangle written = device::addressed(r, message).front().area;
    if (!meet(written, r.window) || contains(r.window, written)) return;
    add(Kind::outside_window,
        "writes " + text_of(written) + ", partly outside of the window " + text_of(r.window),
        std::string(protocol::entry_of(message.opcode).name) +
            " is not clipped by the window: cut the rectangle, if that was expected");
  }

  /// What the host, or a copy, makes use of has not been written in vain.
  void see_used(const Message& message, const Registers& r) {
    switch (message.opcode) {
    case Opcode::read:
    case Opcode::checksum:
      return unseen_.see(image_plane(r.written), device::rectangle_of(message));
    case Opcode::copy:
      return unseen_.see(image_plane(message.operands[index_of(Opcode::copy, "from")]),
                         device::rectangle_of(message));
    case Opcode::read_screen:
      return unseen_.see_screen(r);
    case Opcode::read_overlay:
      return unseen_.see(Plane::overlay);
    case Opcode::buffers:
      if (message.operands[index_of(Opcode::buffers, "shown")] == r.shown) return;
      unseen_.see(Plane::image_0);
      return unseen_.see(Plane::image_1);
    default:
      return;
    }
  }

  void execute(const Message& message, bool is_lost) {
    const Device& device = walk_.device();
    const std::vector<Region> regions = device::addressed(device.registers, message);
    const Work work{number_, written_bits(message, device.registers), 0, 0, 0, erases(message.opcode)};
    const bool may_be_redundant = !is_lost && !is_query(message) && message.opcode != Opcode::mark &&
                                  message.opcode != Opcode::wait && message.opcode != Opcode::reset;
    const Registers registers = device.registers;
    const std::uint32_t field = device::fields(device.clock);
    std::optional<Before> before;
    if (may_be_redundant) before = state_of(device, regions);
    walk_.execute();
    if (before && *before == state_of(device, regions))
      add(Kind::redundant, "changes nothing: " + why_redundant(message), "leave it out");

    // The field may have ended before the command wrote, or after.
    const bool field_ended = device::fields(device.clock) != field;
    if (field_ended) unseen_.see_screen(registers);
    if (!regions.empty() && !is_lost) unseen_.write(work, regions);
    if (field_ended) unseen_.see_screen(device.registers);
  }

  static device::Pixel written_bits(const Message& message, const Registers& r) {
    const bool heeds_mask = goes_through_window(message.opcode) || message.opcode == Opcode::fill ||
                            message.opcode == Opcode::copy;
    return heeds_mask ? r.write_mask : device::Pixel{0xFF, 0xFF, 0xFF};
  }

  void add_lost_work() {
    for (const Work& work : unseen_.works()) {
      const bool is_all = work.lost == work.pixels;
      if (work.lost == 0 || (work.erases && !is_all)) continue;
      const std::string what = std::to_string(work.lost) + " of its " + of_them(work.pixels, "pixel") +
                               " overwritten before they were seen, first by command " +
                               std::to_string(work.by);
      if (is_all)
        findings_.push_back(
            {Kind::never_seen, {work.number}, what, "leave it out, or wait for a field after it"});
      else
        findings_.push_back({Kind::partly_unseen, {work.number}, what, "write less, where time matters"});
    }
  }

  void add(Kind kind, std::string what, std::string advice) {
    findings_.push_back({kind, {number_}, std::move(what), std::move(advice)});
  }

  recording::Walk walk_;
  std::uint64_t number_ = 0;            ///< of the command that is being looked at
  std::optional<std::uint64_t> window_; ///< the last window command, while nothing was written into it
  Unseen unseen_;
  std::vector<Finding> findings_; ///< with the numbers of their commands alone
};

/// Tells the commands in full. In a second walk, since the work that is lost is that of earlier commands.
void refer(const recording::Trace& trace, std::vector<Finding>& findings) {
  recording::Walk walk(trace);
  Sections sections;
  for (auto finding = findings.begin(); finding != findings.end();) {
    const auto step = walk.next();
    if (!step) return; // all findings are about commands of the trace
    sections.follow(*step);
    for (; finding != findings.end() && finding->command.number == step->number; ++finding)
      finding->command = sections.refer_to(*step);
  }
}

} // namespace

std::vector<Finding> lint(const recording::Trace& trace) {
  std::vector<Finding> findings = Linter(trace).run();
  refer(trace, findings);
  return findings;
}

} // namespace halftone::inspect
