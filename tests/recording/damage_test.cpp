#include "random_trace.h"

#include <halftone/device/snapshot.h>
#include <halftone/protocol/checksum.h>
#include <halftone/recording/read.h>
#include <halftone/recording/write.h>

#include <zlib.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

using namespace halftone;
using device::Bytes;
using recording::TraceError;

namespace {

Bytes small_recording() {
  recording::Trace trace;
  trace.header.bus = {"b", 1, 2};
  trace.records = {recording::SessionBegin{"peer"}, recording::Data{{1, 2, 3}}, recording::State{1, 2}};
  return encode(trace);
}

constexpr std::size_t header_size = 8 + 2 + 1 + 1 + 1 + 8 + 8 + 4 + 4;

/// The message of the error that reading ends in; empty if it does not.
std::string refusal(const Bytes& file) {
  try {
    recording::read(file, "t.m508");
  } catch (const TraceError& error) {
    return error.what();
  }
  return {};
}

/// Makes the header's checksum right again.
Bytes sealed(Bytes file) {
  const std::uint32_t sum = protocol::checksum(std::span(file).first(header_size - 4));
  for (std::size_t i = 0; i < 4; ++i)
    file[header_size - 4 + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
  return file;
}

Bytes with_snapshot(const Bytes& packed) {
  recording::Header header;
  header.snapshot = packed;
  return encode(header);
}

Bytes packed(const Bytes& bytes) {
  uLongf size = compressBound(bytes.size());
  Bytes result(size);
  REQUIRE(compress(result.data(), &size, bytes.data(), bytes.size()) == Z_OK);
  result.resize(size);
  return result;
}

} // namespace

TEST_CASE("a restart that says anything is damage") {
  Bytes file = small_recording();
  const Bytes says{5, 0, 0, 0, 1, 'x'};
  file.insert(file.end(), says.begin(), says.end());
  const std::uint32_t sum = protocol::checksum(says);
  for (std::size_t i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(sum >> (24 - 8 * i)));
  CHECK_THAT(refusal(file), Catch::EndsWith("a record of a restart is empty, and this one has 1 bytes"));
}

TEST_CASE("a recording that is cut off anywhere behind its header is read up to there") {
  const Bytes file = small_recording();
  const recording::Trace whole = recording::read(file, "");
  for (std::size_t size = header_size; size < file.size(); ++size) {
    const auto part = recording::read(std::span(file).first(size), "");
    INFO(size);
    CHECK(part.records.size() < whole.records.size());
    CHECK(std::equal(part.records.begin(), part.records.end(), whole.records.begin()));
    CHECK(encode(part) == Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)));
  }
  for (std::size_t size = 8; size < header_size; ++size) {
    INFO(size);
    CHECK_THAT(refusal(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size))),
               Catch::StartsWith("t.m508: byte 0: the file ends in the midst of its header"));
  }
}

TEST_CASE("no changed byte goes unnoticed") {
  const Bytes file = small_recording();
  const recording::Trace whole = recording::read(file, "");
  for (std::size_t at = 0; at < file.size(); ++at) {
    Bytes changed = file;
    changed[at] ^= 0x10;
    INFO(at);
    try {
      const recording::Trace read = recording::read(changed, "");
      // A file without the magic is raw; a length that is too large looks like a file that was cut off.
      CHECK((at < 8 ? read.raw : !read.cut_off.empty()));
    } catch (const TraceError& error) {
      CHECK(error.offset <= at);
    }
  }
}

TEST_CASE("damage is refused with its place and advice") {
  const Bytes file = small_recording();
  const auto changed = [&](std::size_t at, std::uint8_t value) {
    Bytes result = file;
    result[at] = value;
    return result;
  };
  CHECK_THAT(refusal(changed(9, 2)), Catch::StartsWith("t.m508: byte 0: this is version 2 of the format"));
  CHECK_THAT(refusal(changed(13, 2)),
             Catch::StartsWith("t.m508: byte 0: the checksum of the header is wrong"));
  CHECK_THAT(refusal(sealed(changed(10, 9))),
             Catch::StartsWith("t.m508: byte 0: the recording is of command set 9"));
  const std::string at = "t.m508: byte " + std::to_string(header_size) + ": ";
  CHECK_THAT(refusal(changed(header_size + 5, 'P')),
             Catch::StartsWith(at + "the checksum of this record is wrong"));
  CHECK_THAT(refusal(changed(header_size + 1, 1)),
             Catch::StartsWith(at + "a record of 16777220 bytes is longer"));
}

TEST_CASE("a record with a right checksum and wrong content is refused") {
  const auto refused = [](std::uint8_t type, const Bytes& payload) {
    Bytes file = encode(recording::Header{});
    Bytes record{type, 0, 0, 0, static_cast<std::uint8_t>(payload.size())};
    record.insert(record.end(), payload.begin(), payload.end());
    const std::uint32_t sum = protocol::checksum(record);
    for (int shift = 24; shift >= 0; shift -= 8) record.push_back(static_cast<std::uint8_t>(sum >> shift));
    file.insert(file.end(), record.begin(), record.end());
    return refusal(file);
  };
  CHECK_THAT(refused(9, {1}), Catch::Contains("a record of type 9 is unknown"));
  CHECK_THAT(refused(4, {1, 2}), Catch::Contains("a record of a state has 12 bytes, and this one 2"));
  CHECK(refused(1, {1}).empty());
}

TEST_CASE("a snapshot that is none is refused, and one that unpacks to gigabytes takes no memory") {
  const Bytes good = device::save({});
  CHECK(refusal(with_snapshot(packed(good))).empty());
  const auto message = [](const Bytes& snapshot) { return refusal(with_snapshot(snapshot)); };
  CHECK_THAT(message({1, 2, 3}), Catch::Contains("cannot be unpacked"));
  Bytes longer = good;
  longer.push_back(0);
  CHECK_THAT(message(packed(longer)), Catch::Contains("none that a device can have"));
  CHECK_THAT(message(packed(Bytes(64 << 20))), Catch::Contains("cannot be unpacked"));
  Bytes shorter = good;
  shorter.pop_back();
  CHECK_THAT(message(packed(shorter)), Catch::Contains("none that a device can have"));
  Bytes impossible = good;
  impossible[0] = 0xFF; // the window's left column
  CHECK_THAT(message(packed(impossible)), Catch::Contains("none that a device can have"));
  Bytes with_rest = packed(good);
  with_rest.push_back(0);
  CHECK_THAT(message(with_rest), Catch::Contains("cannot be unpacked"));
}

TEST_CASE("a folder and a file that is not there are refused by name") {
  CHECK_THROWS_WITH(recording::read_file("/nowhere/t.m508"), Catch::StartsWith("/nowhere/t.m508: "));
  CHECK_THROWS_WITH(recording::read_file("/"), "/: is a folder");
}
