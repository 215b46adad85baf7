#include "naive_device.h"

#include <cstring>

namespace halftone::test {

namespace {

void put(Bytes& bytes, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void put(Bytes& bytes, const NaiveDevice::Pixel& pixel) {
  bytes.insert(bytes.end(), pixel.begin(), pixel.end());
}

void join(Bytes& all, const Bytes& more) { all.insert(all.end(), more.begin(), more.end()); }

} // namespace

Bytes NaiveDevice::execute(const protocol::Item& item) {
  if (const auto* command = std::get_if<protocol::Message>(&item.content)) return execute(*command);
  const auto& rejection = std::get<protocol::Rejection>(item.content);
  if (errors_ == 0) {
    error_ = static_cast<std::uint32_t>(rejection.fault);
    error_sequence_ = rejection.sequence;
  }
  errors_ += 1;
  if (rejection.fault == protocol::Fault::damaged) skipped_ += static_cast<std::uint32_t>(item.size);
  return {};
}

Bytes NaiveDevice::execute(const protocol::Message& command) {
  const auto& [a, b, c, d, e, f, g, unused] = command.operands;
  Bytes payload;
  switch (static_cast<int>(command.opcode)) {
  case 0x01: {
    payload = {0, 1, 2, 0, 2, 0};
    for (const char character : std::string("M508R, reconstructed")) {
      payload.push_back(static_cast<std::uint8_t>(character));
    }
    return naive_frame(0x81, command.sequence, payload);
  }
  case 0x02:
    *this = {};
    return {};
  case 0x03:
    put(payload, error_, 1);
    for (const std::uint32_t counter : {error_sequence_, errors_, commands_, skipped_})
      put(payload, counter, 4);
    return naive_frame(0x83, command.sequence, payload);
  case 0x10:
    window_ = {a, b, c, d};
    written_ = 0;
    break;
  case 0x11:
    for (std::size_t i = 0; i < command.data.size(); i += 3) {
      write({command.data[i], command.data[i + 1], command.data[i + 2]});
    }
    break;
  case 0x12:
    fill(0, 0, 512, 512, {});
    break;
  case 0x13:
    fill(a, b, c, d,
         {static_cast<std::uint8_t>(e), static_cast<std::uint8_t>(f), static_cast<std::uint8_t>(g)});
    break;
  case 0x20: {
    Bytes replies;
    for (std::uint32_t y = b; y < b + d; ++y) {
      payload.clear();
      put(payload, a, 2);
      put(payload, y, 2);
      for (std::uint32_t x = a; x < a + c; ++x) put(payload, image_[y][x]);
      join(replies, naive_frame(0xA0, command.sequence, payload));
    }
    return replies;
  }
  case 0x21: {
    Bytes area;
    for (std::uint32_t y = b; y < b + d; ++y) {
      for (std::uint32_t x = a; x < a + c; ++x) put(area, image_[y][x]);
    }
    put(payload, naive_checksum(area), 4);
    return naive_frame(0xA1, command.sequence, payload);
  }
  }
  commands_ += 1;
  return {};
}

bool NaiveDevice::holds(const Bytes& image) const {
  return image.size() == sizeof(Pixel) * 512 * 512 &&
         std::memcmp(image.data(), image_.data(), image.size()) == 0;
}

void NaiveDevice::write(Pixel pixel) {
  const std::uint32_t place = written_ % (window_[2] * window_[3]);
  image_[window_[1] + place / window_[2]][window_[0] + place % window_[2]] = pixel;
  written_ += 1;
}

void NaiveDevice::fill(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
                       Pixel pixel) {
  for (std::uint32_t j = y; j < y + height; ++j) {
    for (std::uint32_t i = x; i < x + width; ++i) image_[j][i] = pixel;
  }
}

} // namespace halftone::test
