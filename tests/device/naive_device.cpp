#include "naive_device.h"

#include <cmath>
#include <cstring>

namespace halftone::test {

namespace {

void put_number(Bytes& bytes, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void join(Bytes& all, const Bytes& more) { all.insert(all.end(), more.begin(), more.end()); }

NaiveDevice::Pixel color_of(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), static_cast<std::uint8_t>(blue)};
}

// In picoseconds. Sixty times a clock overflows after three days, which no test waits for.
constexpr std::uint64_t second = 1'000'000'000'000;

} // namespace

NaiveDevice::Memory::Memory() {
  for (auto& lut : luts)
    for (std::size_t i = 0; i < 256; ++i) lut[i] = static_cast<std::uint8_t>(i);
}

Bytes NaiveDevice::execute(const protocol::Item& item) {
  picoseconds_ += item.size * byte_picoseconds_ + item_picoseconds_;
  if (const auto* rejection = std::get_if<protocol::Rejection>(&item.content)) {
    if (memory_.errors == 0) {
      memory_.error = static_cast<std::uint32_t>(rejection->fault);
      memory_.error_sequence = rejection->sequence;
    }
    memory_.errors += 1;
    if (rejection->fault == protocol::Fault::damaged)
      memory_.skipped += static_cast<std::uint32_t>(item.size);
    return {};
  }
  const auto& command = std::get<protocol::Message>(item.content);
  const auto& [a, b, c, d, e, f, g, unused] = command.operands;
  pixels_ = 0;
  const int opcode = static_cast<int>(command.opcode);
  if (opcode == 0x01 || opcode == 0x03 || (opcode >= 0x20 && opcode <= 0x24)) {
    if (opcode >= 0x20 && opcode <= 0x22) pixels_ = c * d;
    take_time(command, pixels_);
    return answer(command);
  }
  obey(command);
  if (opcode != 0x04) take_time(command, pixels_);
  memory_.commands += opcode == 0x02 ? 0 : 1;
  return {};
}

void NaiveDevice::take_time(const protocol::Message& command, std::uint64_t pixels) {
  std::uint64_t nanoseconds = 10'000;
  switch (static_cast<int>(command.opcode)) {
  case 0x02:
  case 0x12:
    nanoseconds = 16'666'667;
    break;
  case 0x11:
  case 0x20:
  case 0x21:
  case 0x22:
    nanoseconds += 400 * pixels;
    break;
  case 0x13:
  case 0x14:
  case 0x15:
  case 0x42:
    nanoseconds += 50 * pixels;
    break;
  case 0x16:
    nanoseconds += 800 * pixels;
    break;
  }
  picoseconds_ += nanoseconds * 1000;
}

Bytes NaiveDevice::answer(const protocol::Message& query) const {
  const auto& [a, b, c, d, e, f, g, unused] = query.operands;
  Bytes replies, payload;
  const auto reply = [&](std::uint8_t opcode) {
    join(replies, naive_frame(opcode, query.sequence, payload));
    payload.clear();
  };
  switch (static_cast<int>(query.opcode)) {
  case 0x01:
    payload = {0, 1, 2, 0, 2, 0};
    for (const char character : std::string("M508R, reconstructed"))
      payload.push_back(static_cast<std::uint8_t>(character));
    reply(0x81);
    break;
  case 0x03:
    put_number(payload, memory_.error, 1);
    for (const std::uint32_t counter :
         {memory_.error_sequence, memory_.errors, memory_.commands, memory_.skipped, field()})
      put_number(payload, counter, 4);
    reply(0x83);
    break;
  case 0x20:
  case 0x22:
    for (std::uint32_t y = b; y < b + d; ++y) {
      put_number(payload, a, 2);
      put_number(payload, y, 2);
      for (std::uint32_t x = a; x < a + c; ++x) {
        const Pixel p = static_cast<int>(query.opcode) == 0x22
                            ? shown(x, y)
                            : pixel(static_cast<int>(memory_.written), x, y);
        payload.insert(payload.end(), p.begin(), p.end());
      }
      reply(0xA0);
    }
    break;
  case 0x21: {
    Bytes area;
    for (std::uint32_t y = b; y < b + d; ++y)
      for (std::uint32_t x = a; x < a + c; ++x) {
        const Pixel p = pixel(static_cast<int>(memory_.written), x, y);
        area.insert(area.end(), p.begin(), p.end());
      }
    put_number(payload, naive_checksum(area), 4);
    reply(0xA1);
    break;
  }
  case 0x23:
    put_number(payload, a, 1);
    join(payload, Bytes(memory_.luts[a].begin(), memory_.luts[a].end()));
    reply(0xA3);
    break;
  case 0x24:
    for (std::uint32_t y = a; y < a + b; ++y) {
      put_number(payload, y, 2);
      for (std::uint32_t x = 0; x < 512; x += 8) {
        std::uint32_t bits = 0;
        for (std::uint32_t i = 0; i < 8; ++i) bits = bits * 2 + (overlay_bit(x + i, y) ? 1 : 0);
        put_number(payload, bits, 1);
      }
      reply(0xA4);
    }
    break;
  }
  return replies;
}

void NaiveDevice::obey(const protocol::Message& command) {
  const auto& [a, b, c, d, e, f, g, unused] = command.operands;
  const auto& data = command.data;
  Memory& m = memory_;
  switch (static_cast<int>(command.opcode)) {
  case 0x02:
    m = {};
    break;
  case 0x04: { // to the first picosecond of the field wanted
    picoseconds_ += 10'000'000;
    const auto wanted = picoseconds_ * 60 / second + a;
    picoseconds_ = (wanted * second + 59) / 60;
    break;
  }
  case 0x10:
    m.window = {a, b, c, d};
    m.position = 0;
    break;
  case 0x11:
    for (std::size_t i = 0; i < data.size(); i += 3) write({data[i], data[i + 1], data[i + 2]});
    break;
  case 0x12:
    for (auto& row : m.images[m.written]) row.fill({});
    break;
  case 0x13:
    for (std::uint32_t y = b; y < b + d; ++y)
      for (std::uint32_t x = a; x < a + c; ++x) put(x, y, color_of(e, f, g));
    break;
  case 0x14:
    for (std::size_t i = 0; i < data.size(); i += 4)
      for (int n = 0; n <= data[i]; ++n) write({data[i + 1], data[i + 2], data[i + 3]});
    break;
  case 0x15:
    for (std::uint32_t n = 0; n < a; ++n) write(color_of(b, c, d));
    break;
  case 0x16: {
    const auto before = m.images[g];
    for (std::uint32_t y = 0; y < d; ++y)
      for (std::uint32_t x = 0; x < c; ++x) put(e + x, f + y, before[b + y][a + x]);
    break;
  }
  case 0x17:
    m.write_mask = color_of(a, b, c);
    break;
  case 0x18:
    m.written = a;
    m.shown = b;
    break;
  case 0x30:
    for (std::uint32_t channel = 0; channel < 3; ++channel)
      for (std::uint32_t i = 0; i < data.size(); ++i)
        if (a & 1U << channel) m.luts[channel][b + i] = data[i];
    break;
  case 0x31:
    for (std::uint32_t channel = 0; channel < 3; ++channel)
      for (std::uint32_t i = 0; i < c; ++i) {
        const double rise = static_cast<double>(e) - d;
        // std::round takes halves away from zero, which is away from `from` here.
        if (a & 1U << channel)
          m.luts[channel][b + i] = static_cast<std::uint8_t>(d + std::round(rise * i / (c - 1)));
      }
    break;
  case 0x32:
    m.read_mask = color_of(a, b, c);
    break;
  case 0x33:
    m.pan_x = a;
    m.pan_y = b;
    break;
  case 0x34:
    m.zoom = 1U << a;
    break;
  case 0x35:
    m.blank = a == 1;
    break;
  case 0x36:
    m.border = a;
    m.border_color = color_of(b, c, d);
    break;
  case 0x40:
    m.overlay_layer = {a, b, color_of(c, d, e)};
    break;
  case 0x41:
    for (std::uint32_t i = 0; i < data.size() * 8; ++i)
      m.overlay[b][8 * a + i] = (data[i / 8] >> (7 - i % 8) & 1) != 0;
    break;
  case 0x42:
    for (std::uint32_t y = b; y < b + d; ++y)
      for (std::uint32_t x = a; x < a + c; ++x, ++pixels_) m.overlay[y][x] = e == 1;
    break;
  case 0x43:
    m.cursor_x = a;
    m.cursor_y = b;
    m.cursor_layer = {c, d, color_of(e, f, g)};
    break;
  case 0x44:
    m.cursor_pattern.assign(data.begin(), data.end());
    break;
  }
}

NaiveDevice::Pixel NaiveDevice::shown(std::uint32_t x, std::uint32_t y) const {
  const Memory& m = memory_;
  if (m.blank) return {};
  if (x < m.border || y < m.border || 511 - x < m.border || 511 - y < m.border) return m.border_color;
  if (is_lit(m.cursor_layer) && x >= m.cursor_x && x < m.cursor_x + 16 && y >= m.cursor_y &&
      y < m.cursor_y + 16) {
    const std::uint32_t column = x - m.cursor_x, row = y - m.cursor_y;
    if (m.cursor_pattern[row * 2 + column / 8] >> (7 - column % 8) & 1) return m.cursor_layer.color;
  }
  if (is_lit(m.overlay_layer) && m.overlay[y][x]) return m.overlay_layer.color;
  Pixel p = m.images[m.shown][(m.pan_y + y / m.zoom) % 512][(m.pan_x + x / m.zoom) % 512];
  for (std::size_t c = 0; c < 3; ++c) p[c] = m.luts[c][p[c] & m.read_mask[c]];
  return p;
}

bool NaiveDevice::holds(int buffer, const Bytes& image) const {
  const auto& rows = memory_.images.at(static_cast<std::size_t>(buffer));
  return image.size() == sizeof(Pixel) * 512 * 512 &&
         std::memcmp(image.data(), rows.data(), image.size()) == 0;
}

bool NaiveDevice::holds_overlay(const Bytes& bits) const {
  if (bits.size() != std::size_t{512} * 64) return false;
  for (std::size_t y = 0; y < 512; ++y)
    for (std::size_t x = 0; x < 512; ++x)
      if ((bits[y * 64 + x / 8] >> (7 - x % 8) & 1) != (memory_.overlay[y][x] ? 1 : 0)) return false;
  return true;
}

bool NaiveDevice::is_lit(const Layer& layer) const {
  return layer.on == 1 && (layer.blink == 0 || field() / layer.blink % 2 == 0);
}

std::uint32_t NaiveDevice::field() const { return static_cast<std::uint32_t>(picoseconds_ * 60 / second); }

void NaiveDevice::write(const Pixel& pixel) {
  const std::uint32_t place = memory_.position % (memory_.window[2] * memory_.window[3]);
  put(memory_.window[0] + place % memory_.window[2], memory_.window[1] + place / memory_.window[2], pixel);
  memory_.position += 1;
}

void NaiveDevice::put(std::uint32_t x, std::uint32_t y, const Pixel& pixel) {
  Pixel& p = memory_.images[memory_.written][y][x];
  for (std::size_t c = 0; c < 3; ++c)
    for (int bit = 1; bit < 256; bit *= 2)
      if (memory_.write_mask[c] & bit) p[c] = static_cast<std::uint8_t>((p[c] & ~bit) | (pixel[c] & bit));
  pixels_ += 1;
}

} // namespace halftone::test
