// The state at the beginning of a recording: a device's snapshot, packed by zlib; and what changes it.

#include <halftone/recording/read.h>
#include <halftone/recording/trace.h>

#include <halftone/device/snapshot.h>

#include <zlib.h>

#include <stdexcept>

namespace halftone::recording {

Bytes pack_state(const device::Device& device) {
  device::Device fresh;
  fresh.clock.bus = device.clock.bus;
  if (device == fresh) return {};
  const Bytes snapshot = device::save(device);
  uLongf size = compressBound(snapshot.size());
  Bytes packed(size);
  if (compress(packed.data(), &size, snapshot.data(), snapshot.size()) != Z_OK)
    throw std::runtime_error("zlib cannot pack a snapshot");
  packed.resize(size);
  return packed;
}

device::Device initial_device(const Header& header) {
  device::Device device;
  if (!header.snapshot.empty()) {
    // One byte more than a snapshot has: whatever unpacks to more does not fit, however much it is.
    static const std::size_t snapshot_size = device::save({}).size();
    Bytes unpacked(snapshot_size + 1);
    uLongf size = unpacked.size();
    uLong taken = header.snapshot.size();
    const int result = uncompress2(unpacked.data(), &size, header.snapshot.data(), &taken);
    if (result != Z_OK || taken != header.snapshot.size())
      throw TraceError({}, "the initial state cannot be unpacked");
    unpacked.resize(size);
    auto restored = device::restore(unpacked);
    if (!restored) throw TraceError({}, "the initial state is none that a device can have");
    device = std::move(*restored);
  }
  device.clock.bus = header.bus;
  return device;
}

protocol::Item restart_item() {
  protocol::Item item;
  item.content = protocol::Message{protocol::Opcode::reset, 0, {}, {}};
  return item;
}

Bytes data_of(const Trace& trace) {
  Bytes all;
  for (const Record& record : trace.records) {
    if (const auto* data = std::get_if<Data>(&record))
      all.insert(all.end(), data->bytes.begin(), data->bytes.end());
  }
  return all;
}

} // namespace halftone::recording
