#pragma once
// Recordings of what a device was sent, as values (docs/trace-format.md).

#include <halftone/device/device.h>
#include <halftone/protocol/decoder.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace halftone::recording {

using device::Bytes;

inline constexpr std::uint16_t format_version = 1;

/// Bytes of a record's payload, at most. A length beyond it is damage, not a record that was cut off.
inline constexpr std::size_t record_limit = std::size_t{1} << 20;

/// Bytes from the client, as received: cut anywhere.
struct Data {
  Bytes bytes;

  bool operator==(const Data&) const = default;
};

/// A client has connected: the device starts to look for frames anew.
struct SessionBegin {
  std::string peer; ///< who, in words

  bool operator==(const SessionBegin&) const = default;
};

/// A client has gone: what it left unfinished is damage.
struct SessionEnd {
  std::string how; ///< in words

  bool operator==(const SessionEnd&) const = default;
};

/// What the device that was recorded had come to.
struct State {
  std::uint64_t commands =
      0; ///< items executed by then, rejections too; the number of the last one in walk.h
  std::uint32_t checksum = 0; ///< device::state_checksum

  bool operator==(const State&) const = default;
};

/// The device has gone off and on, through no command of a client: a fault that was injected. What a client
/// had left unfinished is damage before it.
struct Restart {
  bool operator==(const Restart&) const = default;
};

using Record = std::variant<Data, SessionBegin, SessionEnd, State, Restart>;

struct Header {
  std::uint8_t profile = protocol::reconstructed_profile; ///< which command set
  device::Bus bus;                                        ///< name of at most 255 bytes
  Bytes snapshot; ///< the state at the beginning, as packed by pack_state; empty: as at power-on

  bool operator==(const Header&) const = default;
};

struct Trace {
  Header header;
  std::vector<Record> records;
  Bytes cut_off;    ///< of a last record that is not whole, as after a crash
  bool raw = false; ///< was a stream of commands without header and records: one Data, from power-on

  bool operator==(const Trace&) const = default;
};

/// What a device executes for a Restart: a `reset` that was not sent, and so has no bytes.
protocol::Item restart_item();

/// All data of a trace, one after the other.
Bytes data_of(const Trace& trace);

/// For Header::snapshot; empty where memory, registers and time are those at power-on.
Bytes pack_state(const device::Device& device);

/// The device before the first record, on the header's bus. Throws TraceError (read.h) where the snapshot is
/// none; headers that were read have a good one.
device::Device initial_device(const Header& header);

} // namespace halftone::recording
