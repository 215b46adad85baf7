#pragma once
// Byte streams for the device, made from a fuzzer's bytes: mostly whole frames, since hardly any bytes are.

#include <halftone/protocol/message.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <vector>

namespace halftone::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A command within its limits, of a kind in the opcode table.
inline void append_command(FuzzedDataProvider& fuzz, Bytes& stream) {
  const auto& table = protocol::opcode_table;
  const auto& entry = table[fuzz.ConsumeIntegralInRange<std::size_t>(0, table.size() - 1)];
  protocol::Message message{entry.opcode, fuzz.ConsumeIntegral<std::uint32_t>(), {}, {}};
  Bytes data;
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const protocol::Operand& operand = entry.operands[i];
    const std::uint32_t most = protocol::most_beside(operand, message.operands);
    const auto value = fuzz.ConsumeIntegralInRange<std::uint32_t>(operand.least, most);
    if (protocol::size_of(operand.type) != 0) {
      message.operands[i] = value;
      continue;
    }
    data = fuzz.ConsumeBytes<std::uint8_t>(value * protocol::unit_of(operand.type));
    data.resize(value * protocol::unit_of(operand.type));
    if (operand.type == protocol::OperandType::text)
      for (std::uint8_t& byte : data) byte = static_cast<std::uint8_t>(' ' + byte % 95);
  }
  message.data = data;
  append(stream, message);
}

inline Bytes make_stream(FuzzedDataProvider& fuzz) {
  Bytes stream;
  while (fuzz.remaining_bytes() > 0 && stream.size() < 1 << 16) {
    switch (fuzz.ConsumeIntegralInRange(0, 7)) {
    case 0: { // bytes as they come
      const auto bytes = fuzz.ConsumeBytes<std::uint8_t>(fuzz.ConsumeIntegralInRange<std::size_t>(0, 64));
      stream.insert(stream.end(), bytes.begin(), bytes.end());
      break;
    }
    case 1: { // a whole frame with any operands
      const auto opcode = fuzz.ConsumeIntegral<std::uint8_t>();
      const auto sequence = fuzz.ConsumeIntegral<std::uint32_t>();
      const auto payload = fuzz.ConsumeBytes<std::uint8_t>(fuzz.ConsumeIntegralInRange<std::size_t>(0, 64));
      append(stream, protocol::Frame{opcode, sequence, payload});
      break;
    }
    case 2: // fill
      stream.insert(stream.end(), fuzz.ConsumeIntegralInRange<std::size_t>(0, 5000), std::uint8_t{0});
      break;
    case 3: // a frame that is cut off
      append_command(fuzz, stream);
      stream.resize(stream.size() - fuzz.ConsumeIntegralInRange<std::size_t>(0, 12));
      break;
    default:
      append_command(fuzz, stream);
    }
  }
  return stream;
}

/// Calls take(piece) for the pieces of a stream, cut where the fuzzer's first bytes say.
template<typename Take>
void in_pieces(FuzzedDataProvider& cuts, const Bytes& stream, Take take) {
  for (std::size_t first = 0; first < stream.size();) {
    const std::size_t size = std::min<std::size_t>(
        stream.size() - first,
        cuts.remaining_bytes() == 0 ? stream.size() : 1 + cuts.ConsumeIntegral<std::uint8_t>());
    take(std::span(stream).subspan(first, size));
    first += size;
  }
}

} // namespace halftone::fuzz
