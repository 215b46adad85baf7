#include "random_trace.h"

#include <halftone/device/port.h>
#include <halftone/device/snapshot.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <ctime>
#include <utility>

using namespace halftone;
using device::Bytes;
using recording::Walk;

namespace {

/// The recording executed by the device's own door, session after session.
device::Device executed(const recording::Trace& trace) {
  device::Port port{initial_device(trace.header)};
  Bytes replies;
  for (const recording::Record& record : trace.records) {
    if (const auto* data = std::get_if<recording::Data>(&record))
      port.receive(data->bytes, replies);
    else if (!std::holds_alternative<recording::State>(record))
      port.end(replies);
    if (std::holds_alternative<recording::Restart>(record))
      port.device.execute({0, 0, protocol::Message{protocol::Opcode::reset, 0, {}, {}}}, replies);
  }
  port.end(replies);
  return port.device;
}

Bytes command(protocol::Opcode opcode, std::uint32_t sequence) {
  Bytes bytes;
  append(bytes, protocol::Message{opcode, sequence, {}, {}});
  return bytes;
}

} // namespace

TEST_CASE("a walk brings its device where the device that was recorded came to") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const recording::Trace trace = test::random_trace(random);
    INFO("seed " << seed);
    Walk walk(trace);
    while (walk.next()) {
    }
    REQUIRE(walk.device() == executed(trace));
  }
}

TEST_CASE("steps are numbered from 1, and begin where their bytes are in all data") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const recording::Trace trace = test::random_trace(random);
    const Bytes data = data_of(trace);
    INFO("seed " << seed);
    std::uint64_t number = 0, end = 0;
    for (Walk walk(trace); const auto step = walk.next();) {
      REQUIRE(step->number == ++number);
      REQUIRE(step->offset >= end);
      end = step->offset + step->item.size;
      REQUIRE(end <= data.size());
      if (step->is_restart) {
        REQUIRE(step->item.size == 0);
      } else if (const auto* message = std::get_if<protocol::Message>(&step->item.content)) {
        Bytes again;
        append(again, *message);
        REQUIRE(std::ranges::equal(again, std::span(data).subspan(step->offset, step->item.size)));
      }
    }
  }
}

TEST_CASE("the device is as before the step until it is executed, once") {
  recording::Trace trace;
  Bytes bytes = command(protocol::Opcode::clear, 1);
  const Bytes second = command(protocol::Opcode::clear, 2);
  bytes.insert(bytes.end(), second.begin(), second.end());
  trace.records.emplace_back(recording::Data{bytes});
  Walk walk(trace);
  REQUIRE(walk.next());
  CHECK(walk.device().registers.commands == 0);
  walk.execute();
  CHECK(walk.device().registers.commands == 1);
  walk.execute();
  CHECK(walk.device().registers.commands == 1);
  REQUIRE(walk.next());
  CHECK(walk.device().registers.commands == 1);
  CHECK(!walk.next());
  CHECK(walk.device().registers.commands == 2);
  CHECK(!walk.next());
}

TEST_CASE("a client that leaves in mid-command takes nothing from the next one") {
  recording::Trace trace;
  Bytes half = command(protocol::Opcode::clear, 1);
  half.resize(10);
  const recording::Record whole = recording::Data{command(protocol::Opcode::clear, 2)};
  SECTION("and says so") {
    trace.records = {recording::SessionBegin{"a"}, recording::Data{half}, recording::SessionEnd{"died"},
                     recording::SessionBegin{"b"}, whole};
  }
  SECTION("or not") {
    trace.records = {recording::SessionBegin{"a"}, recording::Data{half}, recording::SessionBegin{"b"},
                     whole};
  }
  Walk walk(trace);
  const auto first = walk.next();
  REQUIRE(first);
  CHECK(std::holds_alternative<protocol::Rejection>(first->item.content));
  CHECK(first->session == 1);
  const auto second = walk.next();
  REQUIRE(second);
  CHECK(std::holds_alternative<protocol::Message>(second->item.content));
  CHECK(second->session == 2);
  CHECK(second->offset == 10);
  CHECK(!walk.next());
  CHECK(walk.device().registers.errors == 1);
  CHECK(walk.device().registers.commands == 1);
}

TEST_CASE("a restart is a step of its own, behind the damage that it makes of what was unfinished") {
  Bytes half = command(protocol::Opcode::clear, 1);
  half.resize(10);
  const recording::Data whole{command(protocol::Opcode::clear, 2)};
  recording::Trace trace;
  trace.records = {recording::Restart{},  recording::SessionBegin{"a"}, whole,
                   recording::Data{half}, recording::Restart{},         whole};
  std::vector<bool> restarts;
  std::vector<std::uint64_t> sessions, offsets;
  Walk walk(trace);
  while (const auto step = walk.next()) {
    restarts.push_back(step->is_restart);
    sessions.push_back(step->session);
    offsets.push_back(step->offset);
    if (step->number == 3) CHECK(std::holds_alternative<protocol::Rejection>(step->item.content));
    if (step->number == 4) CHECK(walk.device().registers.errors == 1);
  }
  CHECK(restarts == std::vector<bool>{true, false, false, true, false});
  CHECK(sessions == std::vector<std::uint64_t>{0, 1, 1, 1, 2});
  CHECK(offsets == std::vector<std::uint64_t>{0, 0, 13, 23, 23});
  CHECK(walk.device().registers.errors == 0);
  CHECK(walk.device().registers.commands == 1);
}

TEST_CASE("a walk over many read-backs does not make the replies") {
  protocol::Item read{0, 21, protocol::Message{protocol::Opcode::read, 1, {0, 0, 512, 512}, {}}};
  Bytes reads;
  for (int i = 0; i < 10'000; ++i) append(reads, std::get<protocol::Message>(read.content));
  recording::Trace trace;
  trace.records = {recording::Data{std::move(reads)}};

  const auto processor_time = [](const auto& task) {
    const std::clock_t begin = std::clock();
    task();
    return std::clock() - begin;
  };
  Walk walk(trace);
  const auto walked = processor_time([&] {
    while (walk.next()) {
    }
  });
  device::Device device;
  const auto answered = processor_time([&] {
    for (int i = 0; i < 500; ++i) {
      Bytes replies;
      device.execute(read, replies);
    }
  });
  // Read-backs are made 20 times as often as they are answered here: a walk that made replies took 20 times
  // as long, and one that makes none takes a hundredth.
  CHECK(walked < answered);
  for (int i = 500; i < 10'000; ++i) device.execute(read);
  CHECK(walk.device() == device);
}

TEST_CASE("the first recorded state that the device does not have is found") {
  recording::Trace trace;
  const std::uint32_t sum = device::state_checksum(device::Device{});
  const recording::Record clear = recording::Data{command(protocol::Opcode::clear, 1)};
  trace.records = {recording::State{0, sum}, clear, recording::State{1, sum}, clear, recording::State{2, 77},
                   recording::State{2, 78}};
  Walk walk(trace, recording::States::compared);
  walk.next();
  walk.next();
  CHECK(!walk.departure());
  CHECK(!walk.next());
  REQUIRE(walk.departure());
  CHECK(walk.departure()->number == 2);
  CHECK(walk.departure()->recorded == recording::State{2, 77});
  CHECK(walk.departure()->checksum == sum);
  CHECK(walk.departure()->agreed == 1U);
}
