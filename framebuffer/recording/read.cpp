#include "format.h"

#include <halftone/recording/read.h>

#include <halftone/protocol/checksum.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace halftone::recording {

namespace {

std::string after_name(const std::string& file, const std::string& rest) {
  return file.empty() ? rest : file + ": " + rest;
}

constexpr const char* transfer_advice = "; was it copied whole, and not as text?";

class Reader {
public:
  Reader(std::span<const std::uint8_t> file, const std::string& name) : file_(file), name_(name) {}

  Header header() {
    Header header;
    take(magic.size());
    const auto version = number(2);
    if (version != format_version)
      fail("this is version " + std::to_string(version) + " of the format, and this program reads version " +
           std::to_string(format_version) + " alone");
    header.profile = static_cast<std::uint8_t>(number(1));
    const auto bus_name = take(number(1));
    header.bus.name.assign(bus_name.begin(), bus_name.end());
    header.bus.byte_picoseconds = number(8);
    header.bus.frame_picoseconds = number(8);
    const auto snapshot = take(number(4));
    const std::uint32_t sum = protocol::checksum(file_.first(position_));
    if (number(4) != sum) fail(std::string("the checksum of the header is wrong") + transfer_advice);
    if (header.profile != protocol::reconstructed_profile)
      fail("the recording is of command set " + std::to_string(header.profile) +
           ", and this program knows command set " + std::to_string(protocol::reconstructed_profile) +
           " alone");
    header.snapshot.assign(snapshot.begin(), snapshot.end());
    if (header.snapshot.empty()) return header;
    try {
      initial_device(header);
    } catch (const TraceError& error) {
      fail(error.what());
    }
    return header;
  }

  /// Nothing at the end of the file, or where what is left is not a whole record.
  std::optional<Record> record() {
    start_ = position_;
    const std::span<const std::uint8_t> rest = file_.subspan(position_);
    if (rest.size() < record_header_size) return std::nullopt;
    const std::size_t length = get(rest.subspan(1, 4));
    if (length > record_limit)
      fail("a record of " + std::to_string(length) + " bytes is longer than any can be (" +
           std::to_string(record_limit) + "): the file is damaged here" + transfer_advice);
    const std::size_t checked = record_header_size + length;
    if (rest.size() < checked + record_checksum_size) return std::nullopt;
    if (get(rest.subspan(checked, record_checksum_size)) != protocol::checksum(rest.first(checked)))
      fail(std::string("the checksum of this record is wrong") + transfer_advice);
    position_ += checked + record_checksum_size;
    return value(rest[0], rest.subspan(record_header_size, length));
  }

  std::span<const std::uint8_t> rest() const { return file_.subspan(position_); }

private:
  [[noreturn]] void fail(const std::string& problem) const { throw TraceError(name_, start_, problem); }

  std::span<const std::uint8_t> take(std::size_t size) {
    if (file_.size() - position_ < size) fail("the file ends in the midst of its header");
    position_ += size;
    return file_.subspan(position_ - size, size);
  }

  std::uint64_t number(std::size_t size) { return get(take(size)); }

  Record value(std::uint8_t type, std::span<const std::uint8_t> payload) const {
    switch (static_cast<RecordType>(type)) {
    case RecordType::data:
      return Data{{payload.begin(), payload.end()}};
    case RecordType::session_begin:
      return SessionBegin{{payload.begin(), payload.end()}};
    case RecordType::session_end:
      return SessionEnd{{payload.begin(), payload.end()}};
    case RecordType::state:
      if (payload.size() != state_size)
        fail("a record of a state has " + std::to_string(state_size) + " bytes, and this one " +
             std::to_string(payload.size()));
      return State{get(payload.first(8)), static_cast<std::uint32_t>(get(payload.last(4)))};
    case RecordType::restart:
      if (!payload.empty())
        fail("a record of a restart is empty, and this one has " + std::to_string(payload.size()) + " bytes");
      return Restart{};
    }
    fail("a record of type " + std::to_string(type) + " is unknown: a newer program may have written it");
  }

  std::span<const std::uint8_t> file_;
  const std::string& name_;
  std::size_t position_ = 0;
  std::size_t start_ = 0; ///< of the header or record being read
};

} // namespace

TraceError::TraceError(const std::string& file, std::size_t byte, const std::string& problem)
    : std::runtime_error(after_name(file, "byte " + std::to_string(byte) + ": " + problem)),
      offset(byte) {}

TraceError::TraceError(const std::string& file, const std::string& problem)
    : std::runtime_error(after_name(file, problem)) {}

bool is_recording(std::span<const std::uint8_t> file) {
  return file.size() >= magic.size() && std::ranges::equal(file.first(magic.size()), magic);
}

Trace read(std::span<const std::uint8_t> file, const std::string& name) {
  Trace trace;
  if (!is_recording(file)) {
    trace.raw = true;
    trace.records.emplace_back(Data{{file.begin(), file.end()}});
    return trace;
  }
  Reader reader(file, name);
  trace.header = reader.header();
  while (auto record = reader.record()) trace.records.push_back(std::move(*record));
  trace.cut_off.assign(reader.rest().begin(), reader.rest().end());
  return trace;
}

std::vector<Record> read_records(std::span<const std::uint8_t> bytes) {
  const std::string no_file;
  Reader reader(bytes, no_file);
  std::vector<Record> records;
  while (auto record = reader.record()) records.push_back(std::move(*record));
  return records;
}

Trace read_file(const std::filesystem::path& file) {
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
    throw TraceError(file.string(), "is a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw TraceError(file.string(), std::generic_category().message(errno));
  Bytes bytes;
  try {
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  } catch (const std::ios_base::failure&) { // how the buffer of the stream says it, without a name
    throw TraceError(file.string(), "cannot be read to its end");
  }
  return read(bytes, file.string());
}

} // namespace halftone::recording
