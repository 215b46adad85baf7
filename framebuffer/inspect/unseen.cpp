#include "unseen.h"

#include <algorithm>

namespace halftone::inspect {

namespace {

using device::Plane;
using device::Rectangle;
using protocol::screen_height;
using protocol::screen_width;

bool covers(const device::Pixel& mask, const device::Pixel& earlier) {
  for (std::size_t c = 0; c < mask.size(); ++c)
    if ((earlier[c] & ~mask[c]) != 0) return false;
  return true;
}

struct Stretch {
  std::uint16_t first;
  std::uint16_t count;
};

/// `count` columns or rows from `first` on, in one piece or, wrapped around, in two.
std::vector<Stretch> wrapped(std::uint32_t first, std::uint32_t count, std::uint32_t all) {
  const auto piece = [](std::uint32_t a, std::uint32_t n) {
    return Stretch{static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(n)};
  };
  if (count == all) return {piece(0, all)};
  if (first + count <= all) return {piece(first, count)};
  return {piece(first, all - first), piece(0, first + count - all)};
}

} // namespace

void Unseen::write(Work work, const std::vector<device::Region>& regions) {
  const auto own = static_cast<std::uint32_t>(works_.size() + 1);
  for (const device::Region& region : regions) {
    const auto plane = static_cast<std::size_t>(region.plane);
    const Rectangle& area = region.area;
    for (std::size_t y = area.y; y < std::size_t{area.y} + area.height; ++y) {
      for (std::size_t x = area.x; x < std::size_t{area.x} + area.width; ++x) {
        std::uint32_t& writer = writers_[plane][y * screen_width + x];
        if (writer == own) continue; // wrapped around a small window
        ++work.pixels;
        if (writer > seen_[plane]) {
          Work& earlier = works_[writer - 1];
          if (covers(work.mask, earlier.mask) && earlier.lost++ == 0) earlier.by = work.number;
        }
        writer = own;
      }
    }
  }
  works_.push_back(work);
}

void Unseen::see(Plane plane) {
  seen_[static_cast<std::size_t>(plane)] = static_cast<std::uint32_t>(works_.size());
}

void Unseen::see(Plane plane, const Rectangle& area) {
  if (area == Rectangle{}) return see(plane); // a host that reads back reads all of it, most often
  Writers& writers = writers_[static_cast<std::size_t>(plane)];
  for (std::size_t y = area.y; y < std::size_t{area.y} + area.height; ++y)
    std::fill_n(&writers[y * screen_width + area.x], area.width, 0U);
}

void Unseen::see_screen(const device::Registers& r) {
  if (r.blank) return;
  if (r.overlay.on) see(Plane::overlay);
  const Plane shown = r.shown == 0 ? Plane::image_0 : Plane::image_1;
  if (r.zoom == 0) return see(shown); // pan wraps around: all of it is there
  for (const Stretch rows : wrapped(r.pan_y, screen_height >> r.zoom, screen_height))
    for (const Stretch columns : wrapped(r.pan_x, screen_width >> r.zoom, screen_width))
      see(shown, {columns.first, rows.first, columns.count, rows.count});
}

} // namespace halftone::inspect
