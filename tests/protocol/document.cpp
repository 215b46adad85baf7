#include "document.h"

#include "naive_codec.h"

#include <halftone/protocol/fault.h>
#include <halftone/protocol/message.h>
#include <halftone/protocol/opcodes.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace halftone::test {

namespace {

using namespace protocol;

Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

/// 0, 1, 2, ...
Bytes counted(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i);
  return bytes;
}

/// A cursor of two lines.
Bytes cross() {
  Bytes bits;
  for (int row = 0; row < 16; ++row) {
    bits.push_back(row == 7 ? 0xFF : 0x01);
    bits.push_back(row == 7 ? 0xFE : 0x00);
  }
  return bits;
}

/// The operands of each example; the data of the one that is shown last.
struct Example {
  Opcode opcode;
  std::array<std::uint32_t, operand_limit> operands;
  Bytes data;
};

Example example_of(Opcode opcode) {
  switch (opcode) {
  case Opcode::identify:
  case Opcode::reset:
  case Opcode::status:
  case Opcode::clear:
    return {opcode, {}, {}};
  case Opcode::wait:
    return {opcode, {60}, {}};
  case Opcode::mark:
    return {opcode, {}, bytes_of("frame 2")};
  case Opcode::window:
    return {opcode, {56, 68, 400, 375}, {}};
  case Opcode::pixels:
    return {opcode, {}, {0xFF, 0, 0, 0x12, 0x34, 0x56}};
  case Opcode::fill:
    return {opcode, {10, 20, 30, 40, 255, 128, 0}, {}};
  case Opcode::runs:
    return {opcode, {}, {99, 0xFF, 0xFF, 0xFF, 0, 0x12, 0x34, 0x56}};
  case Opcode::repeat:
    return {opcode, {1000, 0, 0, 255}, {}};
  case Opcode::copy:
    return {opcode, {0, 0, 64, 32, 100, 200, 1}, {}};
  case Opcode::write_mask:
    return {opcode, {0xFF, 0xF0, 0}, {}};
  case Opcode::buffers:
    return {opcode, {1, 0}, {}};
  case Opcode::read:
  case Opcode::read_screen:
    return {opcode, {10, 20, 2, 1}, {}};
  case Opcode::read_lut:
    return {opcode, {2}, {}};
  case Opcode::read_overlay:
    return {opcode, {100, 16}, {}};
  case Opcode::lut:
    return {opcode, {7, 254}, {0x80, 0xFF}};
  case Opcode::ramp:
    return {opcode, {1, 0, 256, 255, 0}, {}};
  case Opcode::read_mask:
    return {opcode, {0xFF, 0xFF, 0xFE}, {}};
  case Opcode::pan:
    return {opcode, {500, 8}, {}};
  case Opcode::zoom:
    return {opcode, {2}, {}};
  case Opcode::blank:
    return {opcode, {1}, {}};
  case Opcode::border:
    return {opcode, {8, 64, 64, 64}, {}};
  case Opcode::overlay:
    return {opcode, {1, 30, 255, 255, 0}, {}};
  case Opcode::overlay_bits:
    return {opcode, {4, 100}, {0xF0, 0x0F}};
  case Opcode::overlay_fill:
    return {opcode, {32, 100, 16, 16, 1}, {}};
  case Opcode::cursor:
    return {opcode, {248, 248, 1, 0, 255, 255, 255}, {}};
  case Opcode::cursor_pattern:
    return {opcode, {}, cross()};
  case Opcode::table:
    return {opcode, {2}, counted(256)};
  case Opcode::bits:
    return {opcode, {100}, Bytes(64, 0x55)};
  case Opcode::checksum:
    return {opcode, {0, 0, 512, 512}, {}};
  case Opcode::identity:
    return {opcode, {0, 1, 512, 512}, bytes_of("M508R")};
  case Opcode::state:
    return {opcode, {4, 17, 1, 520, 0, 600}, {}};
  case Opcode::row:
    return {opcode, {10, 20}, {0xFF, 0x80, 0, 0xFF, 0x80, 0}};
  case Opcode::sum:
    return {opcode, {naive_checksum(Bytes(512 * 512 * 3, 0))}, {}};
  }
  throw std::logic_error("an opcode without an example");
}

std::string_view name_of(OperandType type) {
  switch (type) {
  case OperandType::u8:
    return "u8";
  case OperandType::u16:
    return "u16";
  case OperandType::u32:
    return "u32";
  case OperandType::pixels:
    return "pixels";
  case OperandType::runs:
    return "runs";
  case OperandType::bytes:
    return "bytes";
  case OperandType::text:
    return "text";
  }
  throw std::logic_error("an operand type without a name");
}

std::string limits_of(const OpcodeEntry& entry, const Operand& operand) {
  std::ostringstream text;
  text << operand.least << " to " << operand.most;
  if (operand.type == OperandType::pixels || operand.type == OperandType::runs) text << " of them";
  if (operand.type == OperandType::bytes) text << " bytes";
  if (operand.type == OperandType::text) text << " characters";
  if (operand.origin >= 0) {
    text << ", " << entry.operands[static_cast<std::size_t>(operand.origin)].name << " + " << operand.name
         << " ≤ " << operand.together;
  }
  return text.str();
}

std::string duration(std::uint32_t nanoseconds) {
  std::ostringstream text;
  if (nanoseconds < 1'000'000) {
    text << nanoseconds / 1e3 << " µs";
  } else {
    text << nanoseconds / 1e6 << " ms";
  }
  return text.str();
}

/// Takes a frame apart, a part a line.
class Dump {
public:
  explicit Dump(Bytes frame) : rest_(std::move(frame)) {}

  void part(std::size_t size, const std::string& meaning) {
    std::ostringstream hex;
    hex << std::hex << std::uppercase << std::setfill('0');
    for (std::size_t i = 0; i < size; ++i) hex << (i ? " " : "") << std::setw(2) << int{rest_.at(i)};
    rest_.erase(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(size));
    text_ << std::left << std::setw(18) << hex.str() << " " << meaning << "\n";
  }

  std::string text() const { return text_.str(); }

private:
  Bytes rest_;
  std::ostringstream text_;
};

std::string dump_of(const OpcodeEntry& entry) {
  constexpr std::uint32_t sequence = 7;
  const Example example = example_of(entry.opcode);
  Bytes frame;
  append(frame, Message{entry.opcode, sequence, example.operands, example.data});
  const std::size_t payload = frame.size() - header_size - checksum_size;

  Dump dump(frame);
  dump.part(2, "sync word");
  dump.part(1, "opcode: " + std::string(entry.name));
  dump.part(4, "sequence number: " + std::to_string(sequence));
  dump.part(2, "length of the payload: " + std::to_string(payload));
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const Operand& operand = entry.operands[i];
    const std::string name(operand.name);
    if (operand.type == OperandType::pixels || operand.type == OperandType::runs) {
      const std::size_t unit = unit_of(operand.type);
      for (std::size_t number = 0; number < example.data.size() / unit; ++number) {
        dump.part(unit, name + ": number " + std::to_string(number));
      }
    } else if (operand.type == OperandType::bytes) {
      for (std::size_t first = 0; first < example.data.size(); first += 16) { // 16 a line
        const std::size_t size = std::min<std::size_t>(16, example.data.size() - first);
        dump.part(size, name + ": from number " + std::to_string(first));
      }
    } else if (operand.type == OperandType::text) {
      dump.part(example.data.size(), name + ": " + std::string(example.data.begin(), example.data.end()));
    } else {
      dump.part(size_of(operand.type), name + ": " + std::to_string(example.operands[i]));
    }
  }
  dump.part(4, "checksum");
  return dump.text();
}

std::string section_of(const OpcodeEntry& entry) {
  std::ostringstream text;
  text << "#### 0x" << std::hex << std::uppercase << std::setw(2) << std::setfill('0')
       << static_cast<int>(entry.opcode) << std::dec << " `" << entry.name << "`\n\n"
       << entry.meaning;
  if (entry.direction == Direction::to_device) {
    text << " Takes " << duration(entry.cost.command);
    if (entry.cost.pixel != 0) text << " and " << duration(entry.cost.pixel) << " a pixel";
    text << ".";
  }
  if (entry.answer) text << " Answered by `" << entry_of(*entry.answer).name << "`.";
  text << "\n\n";
  if (!entry.operands.empty()) text << "| operand | type | limits | meaning |\n|---|---|---|---|\n";
  for (const Operand& operand : entry.operands) {
    text << "| `" << operand.name << "` | " << name_of(operand.type) << " | " << limits_of(entry, operand)
         << " | " << operand.meaning << " |\n";
  }
  if (!entry.operands.empty()) text << "\n";
  text << "```\n" << dump_of(entry) << "```\n\n";
  return text.str();
}

} // namespace

std::string section_of_document(const std::string& name) {
  std::ifstream file(HALFTONE_SOURCE_DIR "/docs/protocol.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string begin = "<!-- begin " + name + " -->\n\n", end = "<!-- end " + name + " -->";
  const std::string document = text.str();
  const std::size_t first = document.find(begin), last = document.find(end);
  if (first == std::string::npos || last == std::string::npos || last < first)
    throw std::logic_error("docs/protocol.md has no section \"" + name + '"');
  return document.substr(first + begin.size(), last - first - begin.size());
}

std::string document_opcodes() {
  std::string text;
  for (const Direction direction : {Direction::to_device, Direction::to_host}) {
    text += direction == Direction::to_device ? "### Commands, from host to device\n\n"
                                              : "### Replies, from device to host\n\n";
    for (const OpcodeEntry& entry : opcode_table) {
      if (entry.direction == direction) text += section_of(entry);
    }
  }
  return text;
}

std::string document_faults() {
  std::ostringstream text;
  text << "| code | error | meaning |\n|---|---|---|\n";
  for (const FaultEntry& entry : fault_table) {
    text << "| " << static_cast<int>(entry.fault) << " | " << entry.name << " | " << entry.meaning << " |\n";
  }
  return text.str();
}

} // namespace halftone::test
