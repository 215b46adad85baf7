#include <halftone/inspect/memory.h>

namespace halftone::inspect {

std::string_view name_of(device::Plane plane) {
  switch (plane) {
  case device::Plane::image_0:
    return "image0";
  case device::Plane::image_1:
    return "image1";
  case device::Plane::overlay:
    break;
  }
  return "overlay";
}

device::Pixel value_at(const device::Device& device, const Place& place) {
  const std::size_t pixel = std::size_t{place.y} * protocol::screen_width + place.x;
  if (place.plane == device::Plane::overlay) {
    const auto bit = static_cast<std::uint8_t>(device.overlay[pixel / 8] >> (7 - pixel % 8) & 1);
    return {bit, bit, bit};
  }
  const device::Bytes& image = device.images[place.plane == device::Plane::image_0 ? 0 : 1];
  const std::size_t i = pixel * protocol::channels;
  return {image[i], image[i + 1], image[i + 2]};
}

std::string text_of(device::Plane plane, const device::Pixel& value) {
  if (plane == device::Plane::overlay) return std::to_string(value[0]);
  return std::to_string(value[0]) + ' ' + std::to_string(value[1]) + ' ' + std::to_string(value[2]);
}

} // namespace halftone::inspect
