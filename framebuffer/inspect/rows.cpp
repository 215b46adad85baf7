#include "rows.h"

namespace halftone::inspect {

std::span<const std::uint8_t> row_of(const device::Device& device, const device::Region& region,
                                     std::size_t y) {
  const device::Rectangle& area = region.area;
  const bool is_overlay = region.plane == device::Plane::overlay;
  const device::Bytes& plane =
      is_overlay ? device.overlay : device.images[region.plane == device::Plane::image_0 ? 0 : 1];
  const std::size_t pitch = plane.size() / protocol::screen_height;
  const std::size_t first = is_overlay ? area.x / 8 : area.x * protocol::channels;
  const std::size_t end =
      is_overlay ? (area.x + area.width + 7) / 8 : (area.x + std::size_t{area.width}) * protocol::channels;
  return std::span(plane).subspan(y * pitch + first, end - first);
}

} // namespace halftone::inspect
