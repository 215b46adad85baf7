#include <halftone/recording/text.h>

#include <halftone/protocol/text.h>
#include <halftone/recording/read.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace halftone::recording {

namespace {

using protocol::Word;
using protocol::Words;

constexpr std::uint64_t u64_most = ~std::uint64_t{0};

class Assembler {
public:
  void line(Words words) {
    if (words.empty()) return;
    const Word first = words.peek();
    if (!first.text.starts_with('.')) {
      if (!trace_.cut_off.empty()) words.fail(first, "nothing comes after \".cut_off\"");
      if (!trace_.raw && group_.empty()) add_data(words, first, std::nullopt);
      items_.append_line(words, bytes_);
      has_items_ = true;
      is_first_ = false;
      return;
    }
    const bool divides = first.text == ".begin" || first.text == ".end" || first.text == ".restart";
    if (!trace_.raw && (has_items_ || divides || !waits_for_items())) close_group();
    words.take({});
    directive(first, words);
    words.end();
    is_first_ = false;
  }

  Trace finish() {
    if (trace_.raw)
      trace_.records.emplace_back(Data{std::move(bytes_)});
    else
      close_group();
    check_snapshot();
    return std::move(trace_);
  }

private:
  /// Data whose bytes are still to come.
  struct Promise {
    std::size_t record = 0;          ///< in the trace
    std::optional<std::size_t> size; ///< nothing: all items up to the next directive
    Words words;                     ///< the line, for messages
    Word word;
  };

  void directive(const Word& name, Words& words) {
    if (name.text == ".trace")
      header(name, words);
    else if (trace_.raw)
      words.fail(name, "only recordings have directives, and they begin with \".trace version=1 ...\"");
    else if (!trace_.cut_off.empty() && name.text != ".cut_off")
      words.fail(name, "nothing comes after \".cut_off\"");
    else if (name.text == ".snapshot")
      snapshot(name, words);
    else if (name.text == ".begin")
      trace_.records.emplace_back(SessionBegin{text(words, "the peer")});
    else if (name.text == ".end")
      trace_.records.emplace_back(SessionEnd{text(words, "how the session ended")});
    else if (name.text == ".restart")
      trace_.records.emplace_back(Restart{});
    else if (name.text == ".data")
      data(name, words);
    else if (name.text == ".state")
      state(words);
    else if (name.text == ".cut_off")
      append_block(words, trace_.cut_off);
    else
      words.fail(name, "unknown directive " + protocol::in_quotes(name.text.substr(0, 40)) +
                           "; known are .trace, .snapshot, .begin, .end, .data, .state, .restart, .cut_off");
  }

  void header(const Word& name, Words& words) {
    if (!is_first_) words.fail(name, "\".trace\" is the first line that is not empty, and the only one");
    trace_.raw = false;
    Header& header = trace_.header;
    number(words, "version", format_version, format_version);
    header.profile = static_cast<std::uint8_t>(
        number(words, "profile", protocol::reconstructed_profile, protocol::reconstructed_profile));
    const Word bus = value(words, "bus");
    header.bus.name = words.quoted(bus, "bus");
    if (header.bus.name.size() > 0xFF) words.fail(bus, "the name of a bus has at most 255 bytes");
    header.bus.byte_picoseconds = number(words, "byte_picoseconds", 0, u64_most);
    header.bus.frame_picoseconds = number(words, "frame_picoseconds", 0, u64_most);
  }

  void snapshot(const Word& name, Words& words) {
    if (!trace_.records.empty()) words.fail(name, "\".snapshot\" comes before the records");
    append_block(words, trace_.header.snapshot);
    if (!snapshot_) snapshot_.emplace(name, words);
  }

  void check_snapshot() const {
    if (!snapshot_) return;
    try {
      initial_device(trace_.header);
    } catch (const TraceError& error) {
      snapshot_->second.fail(snapshot_->first, error.what());
    }
  }

  void state(Words& words) {
    State state;
    state.commands = number(words, "commands", 0, u64_most);
    state.checksum = static_cast<std::uint32_t>(number(words, "checksum", 0, 0xFFFFFFFF));
    trace_.records.emplace_back(state);
  }

  void data(const Word& name, Words& words) {
    std::optional<std::size_t> size;
    if (!words.empty()) size = words.number(words.take({}), "the size of data", 0, record_limit);
    add_data(words, name, size);
  }

  void add_data(const Words& words, const Word& word, std::optional<std::size_t> size) {
    group_.push_back({trace_.records.size(), size, words, word});
    trace_.records.emplace_back(Data{});
  }

  /// Whether sizes were promised, so that further directives belong to the same items.
  bool waits_for_items() const {
    return std::ranges::any_of(group_, [](const Promise& promise) { return promise.size.value_or(0) > 0; });
  }

  /// Hands the bytes of the items to the data whose directives came before them.
  void close_group() {
    std::span<const std::uint8_t> rest = bytes_;
    for (const Promise& promise : group_) {
      if (!promise.size && group_.size() > 1)
        promise.words.fail(promise.word, "\".data\" without a size stands alone before its items");
      const std::size_t size = promise.size.value_or(rest.size());
      if (size > record_limit)
        promise.words.fail(promise.word, "these data have " + std::to_string(size) +
                                             " bytes, and a record has at most " +
                                             std::to_string(record_limit) + "; put a \".data\" in between");
      if (size > rest.size())
        promise.words.fail(promise.word,
                           "the items up to the next directive have too few bytes for this size; "
                           "without a size \".data\" takes all of them");
      std::get<Data>(trace_.records[promise.record]).bytes.assign(rest.begin(), rest.begin() + size);
      rest = rest.subspan(size);
    }
    if (!rest.empty())
      group_.back().words.fail(
          group_.back().word, "the items up to the next directive have " + std::to_string(rest.size()) +
                                  " bytes more than these sizes; without a size \".data\" takes all of them");
    group_.clear();
    bytes_.clear();
    has_items_ = false;
  }

  /// Bytes of which nobody reads a single one: a word of any length.
  static void append_block(Words& words, Bytes& block) {
    const std::string expected = "bytes as hexadecimal digits, two for each";
    if (words.empty()) words.take(expected); // says where they are missing
    const Word word = words.peek();
    const std::size_t unit = word.text.find('*') == word.text.npos ? word.text.size() / 2 : 0;
    if (unit == 0) words.fail(word, "expected " + expected);
    const Bytes bytes = words.units(unit, record_limit);
    block.insert(block.end(), bytes.begin(), bytes.end());
  }

  static Word value(Words& words, const std::string& name) {
    const Word word = words.take(name + "=...");
    const Word value = Words::value_of(word, name);
    if (value.column == 0) words.fail(word, "expected " + name + "=...");
    return value;
  }

  static std::uint64_t number(Words& words, const std::string& name, std::uint64_t least,
                              std::uint64_t most) {
    return words.number(value(words, name), name, least, most);
  }

  static std::string text(Words& words, const std::string& what) {
    const Word word = words.take(what + " in quotes");
    std::string text = words.quoted(word, what);
    if (text.size() > record_limit)
      words.fail(word, what + " has at most " + std::to_string(record_limit) + " bytes");
    return text;
  }

  Trace trace_{{}, {}, {}, true};
  protocol::Assembler items_;
  std::optional<std::pair<Word, Words>> snapshot_; ///< where it is
  bool is_first_ = true;                           ///< no line that is not empty came before
  std::vector<Promise> group_;                     ///< whose items are still to come
  Bytes bytes_;                                    ///< of the items since the last directive
  bool has_items_ = false;                         ///< since then
};

} // namespace

Trace assemble(std::string_view text, const std::string& file) {
  Assembler assembler;
  protocol::for_each_line(
      text, [&](std::string_view line, int number) { assembler.line(Words(line, file, number)); });
  return assembler.finish();
}

} // namespace halftone::recording
