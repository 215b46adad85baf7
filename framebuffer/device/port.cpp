#include <halftone/device/port.h>

namespace halftone::device {

void Port::receive(std::span<const std::uint8_t> bytes, Bytes& replies) {
  while (const auto item = decoder.next(bytes)) device.execute(*item, replies);
}

void Port::end(Bytes& replies) {
  while (const auto item = decoder.drain()) device.execute(*item, replies);
  decoder = protocol::Decoder(protocol::Direction::to_device);
}

} // namespace halftone::device
