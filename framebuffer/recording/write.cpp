#include "format.h"

#include <halftone/recording/write.h>

#include <halftone/device/snapshot.h>
#include <halftone/protocol/checksum.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace halftone::recording {

namespace {

// Long enough that the records' own bytes do not count, short enough that a crash loses little.
constexpr std::size_t data_of_a_record = std::size_t{1} << 16;

template<typename Source>
void put_all(Bytes& bytes, const Source& source) {
  bytes.insert(bytes.end(), source.begin(), source.end());
}

RecordType payload_of(const Record& record, Bytes& payload) {
  if (const auto* data = std::get_if<Data>(&record)) {
    put_all(payload, data->bytes);
    return RecordType::data;
  }
  if (const auto* begin = std::get_if<SessionBegin>(&record)) {
    put_all(payload, begin->peer);
    return RecordType::session_begin;
  }
  if (const auto* end = std::get_if<SessionEnd>(&record)) {
    put_all(payload, end->how);
    return RecordType::session_end;
  }
  if (std::holds_alternative<Restart>(record)) return RecordType::restart;
  const auto& state = std::get<State>(record);
  put(payload, state.commands, 8);
  put(payload, state.checksum, 4);
  return RecordType::state;
}

} // namespace

Bytes encode(const Header& header) {
  assert(header.bus.name.size() <= 0xFF && header.snapshot.size() <= 0xFFFFFFFF);
  Bytes bytes(magic.begin(), magic.end());
  put(bytes, format_version, 2);
  put(bytes, header.profile, 1);
  put(bytes, header.bus.name.size(), 1);
  put_all(bytes, header.bus.name);
  put(bytes, header.bus.byte_picoseconds, 8);
  put(bytes, header.bus.frame_picoseconds, 8);
  put(bytes, header.snapshot.size(), 4);
  put_all(bytes, header.snapshot);
  put(bytes, protocol::checksum(bytes), 4);
  return bytes;
}

Bytes encode(const Record& record) {
  Bytes payload;
  const RecordType type = payload_of(record, payload);
  assert(payload.size() <= record_limit);
  Bytes bytes;
  bytes.reserve(record_header_size + payload.size() + record_checksum_size);
  put(bytes, static_cast<std::uint8_t>(type), 1);
  put(bytes, payload.size(), 4);
  put_all(bytes, payload);
  put(bytes, protocol::checksum(bytes), 4);
  return bytes;
}

Bytes encode(const Trace& trace) {
  if (trace.raw) return data_of(trace);
  Bytes bytes = encode(trace.header);
  for (const Record& record : trace.records) put_all(bytes, encode(record));
  put_all(bytes, trace.cut_off);
  return bytes;
}

Writer::Writer(Sink sink, const device::Device& device) : sink_(std::move(sink)) {
  Header header;
  header.bus = device.clock.bus;
  header.snapshot = pack_state(device);
  sink_(encode(header));
}

void Writer::begin_session(std::string_view peer) {
  sink_(encode(SessionBegin{std::string(peer.substr(0, record_limit))}));
}

void Writer::data(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const auto now = bytes.first(std::min(bytes.size(), data_of_a_record));
    sink_(encode(Data{{now.begin(), now.end()}}));
    bytes = bytes.subspan(now.size());
  }
}

void Writer::end_session(std::string_view how) {
  sink_(encode(SessionEnd{std::string(how.substr(0, record_limit))}));
}

void Writer::restart() { sink_(encode(Restart{})); }

void Writer::executed(const protocol::Item& item, const device::Device& device) {
  ++commands_;
  bytes_ += item.size;
  const auto* message = std::get_if<protocol::Message>(&item.content);
  const bool is_mark = message != nullptr && message->opcode == protocol::Opcode::mark;
  if (is_mark || bytes_ >= state_interval) state(device);
}

void Writer::state(const device::Device& device) {
  bytes_ = 0;
  sink_(encode(State{commands_, device::state_checksum(device)}));
}

} // namespace halftone::recording
