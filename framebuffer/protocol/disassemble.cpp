#include "line_limits.h"

#include <halftone/protocol/decoder.h>
#include <halftone/protocol/text.h>

#include <algorithm>

namespace halftone::protocol {

namespace {

class Disassembler {
public:
  Disassembler(std::span<const std::uint8_t> stream, const std::function<void(const TextLine&)>& take)
      : stream_(stream),
        take_(take) {}

  void add(const Item& item) {
    fill_until(item.offset);
    if (const auto* message = std::get_if<Message>(&item.content)) {
      write(text_of(*message), item.size);
      return;
    }
    const auto& rejection = std::get<Rejection>(item.content);
    if (rejection.fault == Fault::damaged)
      write_bytes(item.size);
    else
      write(text_of(rejection, stream_.subspan(item.offset, item.size)), item.size);
  }

  /// Bytes that belong to no item are zeros.
  void fill_until(std::uint64_t offset) {
    while (written_ < offset) {
      const std::uint64_t count = std::min<std::uint64_t>(offset - written_, line_limit);
      write("zeros " + std::to_string(count), count);
    }
  }

private:
  void write(std::string text, std::uint64_t size) {
    take_({written_, size, std::move(text)});
    written_ += size;
  }

  void write_bytes(std::uint64_t size) {
    for (const std::uint64_t end = written_ + size; written_ < end;) {
      const std::size_t count = std::min<std::uint64_t>(end - written_, line_of_bytes);
      std::string text = "bytes";
      append_units(text, stream_.subspan(written_, count), 1);
      write(std::move(text), count);
    }
  }

  static std::string text_of(const Message& message) {
    const OpcodeEntry& entry = entry_of(message.opcode);
    std::string text = "#" + std::to_string(message.sequence) + " " + std::string(entry.name);
    for (std::size_t i = 0; i < entry.operands.size(); ++i) {
      const Operand& operand = entry.operands[i];
      if (operand.type == OperandType::text) {
        text += " " + in_quotes({reinterpret_cast<const char*>(message.data.data()), message.data.size()});
      } else if (size_of(operand.type) == 0) {
        append_units(text, message.data, unit_of(operand.type));
      } else {
        text += " " + std::string(operand.name) + "=" + std::to_string(message.operands[i]);
      }
    }
    return text;
  }

  static std::string text_of(const Rejection& rejection, std::span<const std::uint8_t> frame) {
    std::string text = "#" + std::to_string(rejection.sequence) + " frame 0x";
    constexpr std::string_view digits = "0123456789abcdef";
    text += {digits[rejection.opcode >> 4], digits[rejection.opcode & 0xF]};
    append_units(text, frame.subspan(header_size, frame.size() - header_size - checksum_size), 1);
    return text + " ; " + std::string(fault_table[static_cast<std::size_t>(rejection.fault)].name);
  }

  std::span<const std::uint8_t> stream_;
  const std::function<void(const TextLine&)>& take_;
  std::uint64_t written_ = 0; ///< bytes that have a line
};

} // namespace

void disassemble(std::span<const std::uint8_t> stream, Direction direction,
                 const std::function<void(const TextLine&)>& take) {
  Disassembler disassembler(stream, take);
  Decoder decoder(direction);
  for (auto rest = stream; const auto item = decoder.next(rest);) disassembler.add(*item);
  while (const auto item = decoder.drain()) disassembler.add(*item);
  disassembler.fill_until(stream.size());
}

std::string disassemble(std::span<const std::uint8_t> stream, Direction direction) {
  std::string text;
  disassemble(stream, direction, [&](const TextLine& line) { text += line.text + '\n'; });
  return text;
}

} // namespace halftone::protocol
