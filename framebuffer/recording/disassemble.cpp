#include <halftone/recording/text.h>

#include <halftone/protocol/text.h>

#include <algorithm>
#include <span>
#include <vector>

namespace halftone::recording {

namespace {

constexpr std::size_t bytes_of_a_line = 48;

/// Bytes that only programs read: as many lines as it takes.
void append_block(std::string& text, const std::string& directive, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const auto now = bytes.first(std::min(bytes.size(), bytes_of_a_line));
    text += directive;
    protocol::append_units(text, now, now.size());
    text += '\n';
    bytes = bytes.subspan(now.size());
  }
}

std::string directive_of(const Record& record) {
  if (const auto* begin = std::get_if<SessionBegin>(&record))
    return ".begin " + protocol::in_quotes(begin->peer) + "\n";
  if (const auto* end = std::get_if<SessionEnd>(&record))
    return ".end " + protocol::in_quotes(end->how) + "\n";
  if (std::holds_alternative<Restart>(record)) return ".restart\n";
  const auto& state = std::get<State>(record);
  return ".state commands=" + std::to_string(state.commands) + " checksum=" + std::to_string(state.checksum) +
         "\n";
}

/// The records of one session. Data are cut anywhere, so a frame may begin in one and end in another: then
/// their directives, with sizes, stand before all items that they share.
class Session {
public:
  Session(std::span<const Record> records, std::string& text) : records_(records), text_(text) {
    for (const Record& record : records) {
      if (const auto* data = std::get_if<Data>(&record))
        stream_.insert(stream_.end(), data->bytes.begin(), data->bytes.end());
    }
    protocol::disassemble(stream_, protocol::Direction::to_device,
                          [&](const protocol::TextLine& line) { lines_.push_back(line); });
  }

  void write() {
    for (std::size_t i = 0; i < records_.size();) {
      if (!std::holds_alternative<Data>(records_[i])) {
        text_ += directive_of(records_[i++]);
        continue;
      }
      const std::size_t end = end_of_group(i);
      const bool alone = end == i + 1 && size_of(records_[i]) > 0;
      for (; i < end; ++i) {
        if (!std::holds_alternative<Data>(records_[i]))
          text_ += directive_of(records_[i]);
        else
          text_ += alone ? ".data\n" : ".data " + std::to_string(size_of(records_[i])) + "\n";
      }
      for (; line_ < lines_.size() && lines_[line_].offset < entered_; ++line_)
        text_ += lines_[line_].text + '\n';
    }
  }

private:
  static std::size_t size_of(const Record& record) {
    const auto* data = std::get_if<Data>(&record);
    return data == nullptr ? 0 : data->bytes.size();
  }

  /// Behind the first data, from this record on, that end where a line ends.
  std::size_t end_of_group(std::size_t i) {
    std::size_t line = line_;
    while (true) {
      entered_ += size_of(records_[i++]);
      while (line < lines_.size() && lines_[line].offset < entered_) ++line;
      const std::uint64_t end = line == 0 ? 0 : lines_[line - 1].offset + lines_[line - 1].size;
      if (end == entered_) return i;
    }
  }

  std::span<const Record> records_;
  std::string& text_;
  Bytes stream_;
  std::vector<protocol::TextLine> lines_;
  std::size_t line_ = 0;      ///< not yet written
  std::uint64_t entered_ = 0; ///< bytes whose directives are written
};

bool is_boundary(const Record& record) {
  return !std::holds_alternative<Data>(record) && !std::holds_alternative<State>(record);
}

} // namespace

std::string disassemble(const Trace& trace) {
  if (trace.raw) return protocol::disassemble(data_of(trace));
  const Header& header = trace.header;
  std::string text = ".trace version=" + std::to_string(format_version) +
                     " profile=" + std::to_string(header.profile) +
                     " bus=" + protocol::in_quotes(header.bus.name) +
                     " byte_picoseconds=" + std::to_string(header.bus.byte_picoseconds) +
                     " frame_picoseconds=" + std::to_string(header.bus.frame_picoseconds) + "\n";
  append_block(text, ".snapshot", header.snapshot);
  std::span<const Record> rest = trace.records;
  while (!rest.empty()) {
    const auto end = std::ranges::find_if(rest.subspan(1), is_boundary);
    const auto count = static_cast<std::size_t>(end - rest.begin());
    Session(rest.first(count), text).write();
    rest = rest.subspan(count);
  }
  append_block(text, ".cut_off", trace.cut_off);
  return text;
}

} // namespace halftone::recording
