#include "naive_codec.h"

#include <array>
#include <iomanip>
#include <optional>
#include <sstream>

namespace halftone::test {

namespace {

void put(Bytes& bytes, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t get(std::span<const std::uint8_t> bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i) value = value * 256 + bytes[at + static_cast<std::size_t>(i)];
  return value;
}

/// Division by the polynomial of ISO 3309, a bit at a time.
std::array<std::uint32_t, 256> remainders_of_bytes() {
  std::array<std::uint32_t, 256> remainders{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) remainder = remainder >> 1 ^ (remainder & 1 ? 0xEDB88320 : 0);
    remainders[byte] = remainder;
  }
  return remainders;
}

/// The size of a good frame at this place, if there is one.
std::optional<std::size_t> frame_at(std::span<const std::uint8_t> stream, std::size_t at) {
  if (stream.size() - at < 13 || stream[at] != 'M' || stream[at + 1] != '5') return {};
  const std::size_t length = get(stream, at + 7, 2);
  if (length > 4096 || stream.size() - at < 13 + length) return {};
  if (get(stream, at + 9 + length, 4) != naive_checksum(stream.subspan(at, 9 + length))) return {};
  return 13 + length;
}

} // namespace

std::uint32_t naive_checksum(std::span<const std::uint8_t> bytes) {
  static const std::array<std::uint32_t, 256> remainders = remainders_of_bytes();
  std::uint32_t remainder = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) remainder = remainder >> 8 ^ remainders[(remainder ^ byte) & 0xFF];
  return ~remainder;
}

Bytes naive_frame(std::uint8_t opcode, std::uint32_t sequence, const Bytes& payload) {
  Bytes frame{'M', '5', opcode};
  put(frame, sequence, 4);
  put(frame, static_cast<std::uint32_t>(payload.size()), 2);
  frame.insert(frame.end(), payload.begin(), payload.end());
  put(frame, naive_checksum(frame), 4);
  return frame;
}

std::vector<std::string> naive_decode(const Bytes& stream, protocol::Direction direction) {
  std::vector<std::string> items;
  std::size_t damaged = 0;
  std::uint32_t last_sequence = 0;
  const auto report_damage = [&](std::size_t end) {
    if (damaged == 0) return;
    items.push_back(
        describe({end - damaged, damaged, protocol::Rejection{protocol::Fault::damaged, last_sequence, 0}}));
    damaged = 0;
  };
  for (std::size_t at = 0; at < stream.size();) {
    if (const auto size = frame_at(stream, at)) {
      report_damage(at);
      last_sequence = get(stream, at + 3, 4);
      const auto payload = std::span(stream).subspan(at + 9, *size - 13);
      items.push_back(
          describe({at, *size, protocol::parse({stream[at + 2], last_sequence, payload}, direction)}));
      at += *size;
    } else {
      if (damaged != 0 || stream[at] != 0) ++damaged;
      ++at;
    }
  }
  report_damage(stream.size());
  return items;
}

std::string describe(const protocol::Item& item) {
  std::ostringstream text;
  text << "bytes " << item.offset << " to " << item.offset + item.size << ": ";
  if (const auto* rejection = std::get_if<protocol::Rejection>(&item.content)) {
    text << protocol::fault_table[static_cast<std::size_t>(rejection->fault)].name << ", opcode "
         << int{rejection->opcode} << ", sequence " << rejection->sequence;
    return text.str();
  }
  const auto& message = std::get<protocol::Message>(item.content);
  const auto& entry = protocol::entry_of(message.opcode);
  text << entry.name << " " << message.sequence;
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    text << " " << entry.operands[i].name << "=" << message.operands[i];
  }
  text << std::hex << std::setfill('0') << " ";
  for (const std::uint8_t byte : message.data) text << std::setw(2) << int{byte};
  return text.str();
}

} // namespace halftone::test
