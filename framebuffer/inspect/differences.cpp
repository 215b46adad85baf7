// Comparing two devices wholly: once, when something is known to differ.

#include <halftone/inspect/diff.h>
#include <halftone/inspect/memory.h>
#include <halftone/inspect/settings.h>

#include <algorithm>
#include <array>

namespace halftone::inspect {

namespace {

using device::Device;
using device::Plane;
using Part = Difference::Part;

void add_pixels(const Device& a, const Device& b, Plane plane, std::vector<Difference>& all) {
  std::uint16_t left = 0, right = 0, top = 0, bottom = 0;
  Difference found{Part::pixels, std::string(name_of(plane)), 0, 0, {}, {}, 0, {}};
  for (std::uint16_t y = 0; y < protocol::screen_height; ++y) {
    for (std::uint16_t x = 0; x < protocol::screen_width; ++x) {
      const device::Pixel of_a = value_at(a, {plane, x, y}), of_b = value_at(b, {plane, x, y});
      if (of_a == of_b) continue;
      if (found.count++ == 0) {
        found.x = left = right = x;
        found.y = top = y;
        found.a = text_of(plane, of_a);
        found.b = text_of(plane, of_b);
      }
      left = std::min(left, x);
      right = std::max(right, x);
      bottom = y;
    }
  }
  if (found.count == 0) return;
  found.bounds = {left, top, static_cast<std::uint16_t>(right - left + 1),
                  static_cast<std::uint16_t>(bottom - top + 1)};
  all.push_back(found);
}

template<typename Table>
void add_table(const Table& a, const Table& b, Part part, const std::string& name,
               std::vector<Difference>& all) {
  Difference found{part, name, 0, 0, {}, {}, 0};
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (found.count++ != 0) continue;
    found.x = static_cast<std::uint32_t>(i);
    found.a = std::to_string(a[i]);
    found.b = std::to_string(b[i]);
  }
  if (found.count != 0) all.push_back(found);
}

void add_settings(const Device& a, const Device& b, std::vector<Difference>& all) {
  const std::vector<Setting> of_a = settings(a.registers), of_b = settings(b.registers);
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (of_a[i] == of_b[i] || of_a[i].name == "commands") continue;
    all.push_back({Part::setting, std::string(of_a[i].name), 0, 0, text_of(of_a[i].values),
                   text_of(of_b[i].values), 1});
  }
}

} // namespace

std::vector<Difference> differences(const Device& a, const Device& b, const Comparison& comparison) {
  std::vector<Difference> all;
  if (a.images[0] != b.images[0]) add_pixels(a, b, Plane::image_0, all);
  if (a.images[1] != b.images[1]) add_pixels(a, b, Plane::image_1, all);
  if (a.overlay != b.overlay) add_pixels(a, b, Plane::overlay, all);
  for (std::size_t c = 0; c < protocol::channels; ++c)
    add_table(a.luts[c], b.luts[c], Part::lut, std::string(channel_names[c]), all);
  add_table(a.cursor_pattern, b.cursor_pattern, Part::cursor_pattern, "cursor_pattern", all);
  add_settings(a, b, all);
  if (!comparison.ignore_clock && a.clock.picoseconds != b.clock.picoseconds)
    all.push_back({Part::clock, "clock", 0, 0, std::to_string(a.clock.picoseconds),
                   std::to_string(b.clock.picoseconds), 1});
  return all;
}

} // namespace halftone::inspect
