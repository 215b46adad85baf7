#include <halftone/protocol/words.h>

#include "printable.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>

namespace halftone::protocol {

namespace {

constexpr std::string_view digits = "0123456789abcdef";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The word as it is shown in messages: on one line, the end of a long one left out.
std::string shown(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string text(word.substr(0, most));
  std::ranges::replace_if(
      text, [](unsigned char c) { return !is_printable(c); }, '?');
  return "\"" + text + (word.size() > most ? "...\"" : "\"");
}

/// The digits as a number; nothing where they are none, or one of more than 64 bits.
std::optional<std::uint64_t> to_number(std::string_view text) {
  const bool hexadecimal = text.starts_with("0x");
  if (hexadecimal) text.remove_prefix(2);
  std::uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, hexadecimal ? 16 : 10);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Bytes from pairs of digits, which are `text` as a whole.
bool append_hexadecimal(std::string_view text, std::vector<std::uint8_t>& bytes) {
  if (text.size() % 2 != 0) return false;
  for (; !text.empty(); text.remove_prefix(2)) {
    std::uint8_t byte = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + 2, byte, 16);
    if (error != std::errc() || end != text.data() + 2) return false;
    bytes.push_back(byte);
  }
  return true;
}

} // namespace

TextError::TextError(const std::string& file, int line_number, int column_number, const std::string& problem)
    : std::runtime_error((file.empty() ? "" : file + ":") + std::to_string(line_number) + ":" +
                         std::to_string(column_number) + ": " + problem),
      line(line_number),
      column(column_number) {}

Words::Words(std::string_view line, const std::string& file, int number) : file_(file), number_(number) {
  std::size_t at = 0;
  while (true) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at == line.size() || line[at] == ';') break;
    const std::size_t start = at;
    bool in_quotes = false;
    for (; at < line.size() && (in_quotes || (!is_blank(line[at]) && line[at] != ';')); ++at) {
      if (in_quotes && line[at] == '\\' && at + 1 < line.size())
        ++at;
      else if (line[at] == '"')
        in_quotes = !in_quotes;
    }
    words_.push_back({line.substr(start, at - start), static_cast<int>(start) + 1});
  }
  end_ = {line.substr(at, 0), static_cast<int>(at) + 1};
}

Word Words::take(const std::string& expected) {
  if (empty()) fail(end_, "expected " + expected + ", and the line ends here");
  return words_[next_++];
}

void Words::end() const {
  if (!empty()) fail(peek(), "expected the end of the line, found " + shown(peek().text));
}

void Words::fail(const Word& at, const std::string& problem) const {
  throw TextError(file_, number_, at.column, problem);
}

std::uint64_t Words::number(const Word& word, const std::string& what, std::uint64_t least,
                            std::uint64_t most) const {
  const auto value = to_number(word.text);
  if (!value || *value < least || *value > most)
    fail(word, what + " is a number from " + std::to_string(least) + " to " + std::to_string(most) +
                   ", found " + shown(word.text));
  return *value;
}

std::string Words::quoted(const Word& word, const std::string& what) const {
  const std::string_view text = word.text;
  if (text.empty() || text.front() != '"') fail(word, what + " is a text in quotes, found " + shown(text));
  std::string result;
  for (std::size_t i = 1; i < text.size(); ++i) {
    const Word here{text.substr(i), word.column + static_cast<int>(i)};
    if (text[i] == '"' && i + 1 == text.size()) return result;
    if (text[i] == '"') fail(here, "expected a blank after the quotes");
    if (!is_printable(static_cast<unsigned char>(text[i])))
      fail(here, "only printable ASCII may stand in quotes; write \\x0a for byte 10");
    if (text[i] != '\\') {
      result += text[i];
      continue;
    }
    std::vector<std::uint8_t> byte;
    if (++i < text.size() && (text[i] == '"' || text[i] == '\\')) {
      result += text[i];
    } else if (i + 2 < text.size() && text[i] == 'x' && append_hexadecimal(text.substr(i + 1, 2), byte)) {
      result += static_cast<char>(byte[0]);
      i += 2;
    } else {
      fail(here, "a backslash stands before \", \\, or x and two hexadecimal digits");
    }
  }
  fail(word, "the quotes are not closed");
}

std::vector<std::uint8_t> Words::units(std::size_t unit, std::size_t most) {
  std::vector<std::uint8_t> bytes;
  while (!empty()) {
    const Word word = words_[next_++];
    const std::size_t star = word.text.find('*');
    const std::string_view once = word.text.substr(0, star);
    std::vector<std::uint8_t> value;
    if (once.size() != 2 * unit || !append_hexadecimal(once, value))
      fail(word, "expected " + std::to_string(2 * unit) + " hexadecimal digits, found " + shown(word.text));
    std::uint64_t count = 1;
    if (star != std::string_view::npos) {
      const Word repeats{word.text.substr(star + 1), word.column + static_cast<int>(star) + 1};
      count = number(repeats, "how often bytes are repeated", 1, 0xFFFFFFFF);
    }
    if (count > (most - bytes.size()) / unit)
      fail(word, "with these there are more bytes than the " + std::to_string(most) + " allowed here");
    for (; count > 0; --count) bytes.insert(bytes.end(), value.begin(), value.end());
  }
  return bytes;
}

Word Words::value_of(const Word& word, std::string_view name) {
  if (!word.text.starts_with(name) || !word.text.substr(name.size()).starts_with('=')) return {};
  const std::size_t before = name.size() + 1;
  return {word.text.substr(before), word.column + static_cast<int>(before)};
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<std::uint8_t>(c);
    if (!is_printable(byte)) {
      result += {'\\', 'x', digits[byte >> 4], digits[byte & 0xF]};
      continue;
    }
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

void append_units(std::string& text, std::span<const std::uint8_t> bytes, std::size_t unit) {
  assert(bytes.size() % unit == 0);
  while (!bytes.empty()) {
    const auto value = bytes.first(unit);
    std::size_t count = 0;
    for (; !bytes.empty() && std::ranges::equal(bytes.first(unit), value); bytes = bytes.subspan(unit))
      ++count;
    // A repeat is written out where that is no longer.
    const std::string star = "*" + std::to_string(count);
    const bool abbreviated = star.size() < (count - 1) * (2 * unit + 1);
    for (std::size_t i = 0; i < (abbreviated ? 1 : count); ++i) {
      text += ' ';
      for (const std::uint8_t byte : value) text += {digits[byte >> 4], digits[byte & 0xF]};
    }
    if (abbreviated) text += star;
  }
}

} // namespace halftone::protocol
