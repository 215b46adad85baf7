#include "random_trace.h"

#include <halftone/device/port.h>
#include <halftone/recording/read.h>
#include <halftone/recording/text.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <vector>

using namespace halftone;
using device::Bytes;

TEST_CASE("a random recording is read as it was written") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const recording::Trace trace = test::random_trace(random);
    INFO("seed " << seed);
    REQUIRE(recording::read(encode(trace), "") == trace);
  }
}

TEST_CASE("a random recording is assembled from its text form, byte for byte") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const recording::Trace trace = test::random_trace(random);
    INFO("seed " << seed);
    REQUIRE(encode(recording::assemble(recording::disassemble(trace))) == encode(trace));
  }
}

TEST_CASE("a file without the magic is a raw stream from power-on") {
  test::Random random(1);
  const auto stream = test::random_stream(random, protocol::Direction::to_device);
  const recording::Trace trace = recording::read(stream, "");
  CHECK(trace.raw);
  CHECK(data_of(trace) == stream);
  CHECK(initial_device(trace.header) == device::Device{});
  CHECK(encode(recording::assemble(recording::disassemble(trace))) == stream);
  CHECK(recording::read(Bytes{}, "").raw);
}

TEST_CASE("what a writer has written so far is a whole recording after every call") {
  Bytes file;
  std::vector<std::size_t> ends;
  device::Port port;
  port.device.clock.bus = {"a bus", 3, 4};
  recording::Writer writer(
      [&](std::span<const std::uint8_t> bytes) {
        file.insert(file.end(), bytes.begin(), bytes.end());
        ends.push_back(file.size());
      },
      port.device);
  Bytes stream(200'000, 0x55), replies;
  writer.begin_session("somebody");
  writer.data(stream);
  port.receive(stream, replies);
  port.end(replies);
  writer.end_session("closed");
  writer.state(port.device);

  for (const std::size_t end : ends) CHECK(recording::read(std::span(file).first(end), "").cut_off.empty());
  const recording::Trace trace = recording::read(file, "");
  CHECK(trace.header.bus == device::Bus{"a bus", 3, 4});
  CHECK(trace.header.snapshot.empty());
  CHECK(data_of(trace) == stream);
  CHECK(trace.records.front() == recording::Record{recording::SessionBegin{"somebody"}});
}

TEST_CASE("a recording that begins in mid-life holds the device's whole state") {
  test::Random random(7);
  device::Port port;
  Bytes replies;
  for (int i = 0; i < 50; ++i)
    port.receive(test::random_stream(random, protocol::Direction::to_device), replies);
  port.device.clock.bus = {"b", 1, 2};
  Bytes file;
  const recording::Writer writer(
      [&](std::span<const std::uint8_t> bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
      port.device);
  CHECK(initial_device(recording::read(file, "").header) == port.device);
}
