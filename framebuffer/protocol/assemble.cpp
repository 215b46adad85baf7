#include "line_limits.h"
#include "nearest.h"
#include "printable.h"

#include <halftone/protocol/message.h>
#include <halftone/protocol/text.h>

#include <algorithm>
#include <array>

namespace halftone::protocol {

namespace {

std::string quoted_name(std::string_view name) { return "\"" + std::string(name) + "\""; }

/// Everything that a line can begin with after its number.
std::vector<std::string_view> known_names() {
  std::vector<std::string_view> names;
  for (const OpcodeEntry& entry : opcode_table) names.push_back(entry.name);
  for (const std::string_view name : {"bytes", "zeros", "frame"}) names.push_back(name);
  return names;
}

std::vector<std::string_view> numbers_of(const OpcodeEntry& entry) {
  std::vector<std::string_view> names;
  for (const Operand& operand : entry.operands)
    if (size_of(operand.type) != 0) names.push_back(operand.name);
  return names;
}

/// Where name=value is, of an operand of the entry.
std::size_t operand_of(const Words& words, const Word& word, const OpcodeEntry& entry) {
  for (std::size_t i = 0; i < entry.operands.size(); ++i) {
    const Operand& operand = entry.operands[i];
    if (size_of(operand.type) != 0 && Words::value_of(word, operand.name).column != 0) return i;
  }
  const std::string_view name = word.text.substr(0, word.text.find('='));
  words.fail(word, "unknown operand " + in_quotes(name.substr(0, 40)) + " of " + std::string(entry.name) +
                       advice_on(name, numbers_of(entry)));
}

/// name=value, each once and in any order.
void read_numbers(Words& words, const OpcodeEntry& entry, Message& message) {
  std::array<Word, operand_limit> values{};
  const std::vector<std::string_view> names = numbers_of(entry);
  for (std::size_t count = 0; count < names.size(); ++count) {
    std::string missing;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (values[i].column == 0) missing += (missing.empty() ? "" : " ") + std::string(names[i]) + "=...";
    const Word word = words.take(missing);
    if (word.text.find('=') == std::string_view::npos)
      words.fail(word, "expected " + missing + ", found " + in_quotes(word.text.substr(0, 40)));
    const std::size_t index = operand_of(words, word, entry);
    const Operand& operand = entry.operands[index];
    if (values[index].column != 0) words.fail(word, "there is a second " + std::string(operand.name));
    values[index] = Words::value_of(word, operand.name);
    message.operands[index] = static_cast<std::uint32_t>(
        words.number(values[index], std::string(operand.name), operand.least, operand.most));
  }
  for (std::size_t i = 0; i < names.size(); ++i) { // numbers come before data: indices are the table's
    const Operand& operand = entry.operands[i];
    if (operand.origin < 0) continue;
    const auto origin = static_cast<std::size_t>(operand.origin);
    if (message.operands[i] > most_beside(operand, message.operands))
      words.fail(values[i], std::string(names[origin]) + " + " + std::string(operand.name) + " is at most " +
                                std::to_string(operand.together) +
                                "; a frame that is to be refused is written "
                                "with \"frame\"");
  }
}

/// The data of a layout that ends in some.
std::vector<std::uint8_t> read_data(Words& words, const Operand& operand, const Message& message) {
  const std::size_t unit = unit_of(operand.type);
  const std::size_t most = most_beside(operand, message.operands);
  const std::string what =
      std::to_string(operand.least) + " to " + std::to_string(most) + " " +
      (operand.type == OperandType::text ? "characters in quotes"
                                         : "units of " + std::to_string(2 * unit) + " hexadecimal digits");
  if (words.empty()) words.take(what); // says where they are missing
  const Word first = words.peek();
  std::vector<std::uint8_t> data;
  if (operand.type == OperandType::text) {
    const std::string text = words.quoted(words.take(what), std::string(operand.name));
    data.assign(text.begin(), text.end());
    if (!std::ranges::all_of(data, is_printable))
      words.fail(first, std::string(operand.name) + " is printable ASCII");
  } else {
    data = words.units(unit, payload_limit);
  }
  if (data.size() / unit < operand.least || data.size() / unit > most)
    words.fail(first, "expected " + what + ", found " + std::to_string(data.size() / unit));
  return data;
}

void append_message(Words& words, const OpcodeEntry& entry, std::uint32_t sequence,
                    std::vector<std::uint8_t>& stream) {
  Message message{entry.opcode, sequence, {}, {}};
  std::vector<std::uint8_t> data;
  read_numbers(words, entry, message);
  if (!entry.operands.empty() && size_of(entry.operands.back().type) == 0) {
    data = read_data(words, entry.operands.back(), message);
    message.data = data;
  }
  words.end();
  append(stream, message);
}

} // namespace

void Assembler::append_line(Words& words, std::vector<std::uint8_t>& stream) {
  if (words.empty()) return;
  std::uint32_t sequence = sequence_ + 1;
  const Word first = words.peek();
  const bool numbered = first.text.starts_with('#');
  if (numbered) {
    words.take({});
    sequence = static_cast<std::uint32_t>(
        words.number({first.text.substr(1), first.column + 1}, "the number after #", 0, 0xFFFFFFFF));
  }
  const Word name = words.take("the name of a command");
  if (name.text == "bytes" || name.text == "zeros") {
    if (numbered) words.fail(first, quoted_name(name.text) + " has no sequence number");
    if (name.text == "zeros") {
      const Word count = words.take("how many zeros");
      stream.resize(stream.size() + words.number(count, "the count of zeros", 1, line_limit));
      words.end();
    } else {
      if (words.empty()) words.take("bytes of two hexadecimal digits"); // says where they are missing
      const auto bytes = words.units(1, line_limit);
      stream.insert(stream.end(), bytes.begin(), bytes.end());
    }
    return;
  }
  if (name.text == "frame") {
    const auto opcode = words.number(words.take("an opcode"), "the opcode", 0, 0xFF);
    const auto payload = words.units(1, payload_limit);
    append(stream, Frame{static_cast<std::uint8_t>(opcode), sequence, payload});
  } else if (const OpcodeEntry* entry = find(name.text)) {
    append_message(words, *entry, sequence, stream);
  } else {
    words.fail(name,
               "unknown command " + in_quotes(name.text.substr(0, 40)) + advice_on(name.text, known_names()));
  }
  sequence_ = sequence;
}

std::vector<std::uint8_t> assemble(std::string_view text, const std::string& file) {
  std::vector<std::uint8_t> stream;
  Assembler assembler;
  for_each_line(text, [&](std::string_view line, int number) {
    Words words(line, file, number);
    assembler.append_line(words, stream);
  });
  return stream;
}

void for_each_line(std::string_view text, const std::function<void(std::string_view, int)>& take) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    take(text.substr(0, end), number);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

} // namespace halftone::protocol
