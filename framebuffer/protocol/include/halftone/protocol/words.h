#pragma once
// The words that a line of the text form is made of, and how they are written (docs/text-form.md).

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::protocol {

/// Text that is no text form. what() is one line:
///   test.txt:12:7: unknown operand "widht" of window; did you mean "width"?
class TextError : public std::runtime_error {
public:
  TextError(const std::string& file, int line_number, int column_number, const std::string& problem);

  int line = 0; ///< from 1
  int column = 0;
};

/// What stands between blanks; blanks in quotes are part of it.
struct Word {
  std::string_view text;
  int column = 0; ///< of its first byte, from 1
};

/// A line, taken word by word. The text has to outlive it.
class Words {
public:
  /// `file` is used in messages alone. What follows a semicolon is left out.
  Words(std::string_view line, const std::string& file, int number);

  bool empty() const { return next_ == words_.size(); }
  const Word& peek() const { return words_[next_]; }

  /// The next word; where there is none, "expected ..., and the line ends here".
  Word take(const std::string& expected);

  /// Throws "expected the end of the line, ..." if there are more words.
  void end() const;

  [[noreturn]] void fail(const Word& at, const std::string& problem) const;

  /// A decimal number, or a hexadecimal one after 0x, from least to most; `what` names it in messages.
  std::uint64_t number(const Word& word, const std::string& what, std::uint64_t least,
                       std::uint64_t most) const;

  /// Any bytes: printable ASCII in quotes, where \" and \\ stand for " and \, and \x0a for byte 10.
  std::string quoted(const Word& word, const std::string& what) const;

  /// All words that are left, as bytes: two hexadecimal digits for each byte of a unit, and *count after it
  /// where it is repeated. More than `most` bytes are refused before they are made.
  std::vector<std::uint8_t> units(std::size_t unit, std::size_t most);

  /// For name=value: the value as a word of its own if the name is this one, else empty.
  static Word value_of(const Word& word, std::string_view name);

private:
  std::vector<Word> words_;
  std::size_t next_ = 0;
  Word end_; ///< an empty word after the last
  const std::string& file_;
  int number_;
};

/// As Words reads it.
std::string in_quotes(std::string_view text);

/// Appends " 00 ff0000*3": bytes in units, equal neighbours together. All bytes are in whole units.
void append_units(std::string& text, std::span<const std::uint8_t> bytes, std::size_t unit);

} // namespace halftone::protocol
