#include "../protocol/random_message.h"

#include <halftone/device/snapshot.h>
#include <halftone/protocol/text.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace halftone;
using device::Bytes;
using recording::Departure;
using recording::State;

namespace {

/// What a recorder makes of a stream that comes in pieces of up to so many bytes.
recording::Trace recorded(const Bytes& stream, std::size_t largest_piece) {
  Bytes file;
  device::Device device;
  recording::Writer writer(
      [&](std::span<const std::uint8_t> bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
      device);
  protocol::Decoder decoder(protocol::Direction::to_device);
  writer.begin_session("test");
  for (std::span<const std::uint8_t> rest = stream; !rest.empty();) {
    auto piece = rest.first(std::min(rest.size(), largest_piece));
    rest = rest.subspan(piece.size());
    writer.data(piece);
    while (const auto item = decoder.next(piece)) {
      device.execute(*item);
      writer.executed(*item, device);
    }
  }
  while (const auto item = decoder.drain()) {
    device.execute(*item);
    writer.executed(*item, device);
  }
  writer.end_session("done");
  writer.state(device);
  return recording::read(file, "");
}

std::vector<State> states_of(const recording::Trace& trace) {
  std::vector<State> states;
  for (const recording::Record& record : trace.records)
    if (const auto* state = std::get_if<State>(&record)) states.push_back(*state);
  return states;
}

/// Two frames with a mark behind each, damage in the second.
Bytes frames() {
  Bytes stream;
  test::Random random(1);
  Bytes pixels(std::size_t{512} * 3);
  std::uint32_t sequence = 0;
  for (const char* name : {"frame 1", "frame 2"}) {
    for (int row = 0; row < 1024; ++row) {
      for (std::uint8_t& byte : pixels) byte = static_cast<std::uint8_t>(random());
      append(stream, protocol::Message{protocol::Opcode::pixels, ++sequence, {}, pixels});
    }
    const std::string text(name);
    append(stream,
           protocol::Message{protocol::Opcode::mark, ++sequence, {}, Bytes(text.begin(), text.end())});
  }
  stream.back() ^= 1;
  append(stream, protocol::Message{protocol::Opcode::clear, ++sequence, {}, {}});
  return stream;
}

} // namespace

TEST_CASE(
    "states are noted after marks, after each 1 MiB of commands and in the end, however the data are cut") {
  const Bytes stream = frames();
  const std::vector<State> states = states_of(recorded(stream, stream.size()));
  // 677 commands of 1,549 bytes are the first beyond 1,048,576. The last mark is damaged, and no mark.
  std::vector<std::uint64_t> commands;
  for (const State& state : states) commands.push_back(state.commands);
  CHECK(commands == std::vector<std::uint64_t>{677, 1025, 1702, 2051});
  for (const std::size_t largest : {1, 1000, 65'536, 1'000'000}) {
    const recording::Trace trace = recorded(stream, largest);
    INFO("pieces of " << largest);
    CHECK(states_of(trace) == states);
    CHECK_FALSE(departure(trace));
  }
}

TEST_CASE("the first state that differs is told, and the last before it that did not") {
  const recording::Trace good = recorded(frames(), 65'536);
  const std::vector<State> states = states_of(good);
  const auto departure_with = [&](std::size_t wrong) {
    recording::Trace trace = good;
    std::size_t number = 0;
    for (recording::Record& record : trace.records)
      if (auto* state = std::get_if<State>(&record); state != nullptr && number++ >= wrong)
        state->checksum ^= 1;
    return departure(trace);
  };
  for (std::size_t wrong = 0; wrong < states.size(); ++wrong) {
    Departure expected{states[wrong].commands, states[wrong], states[wrong].checksum, {}};
    expected.recorded.checksum ^= 1;
    if (wrong > 0) expected.agreed = states[wrong - 1].commands;
    INFO(wrong);
    REQUIRE(departure_with(wrong));
    CHECK((*departure_with(wrong) == expected));
  }
}

TEST_CASE("a command that is not as it was recorded is found between two marks") {
  const std::string text = "zoom shift=1\nmark \"a\"\npan x=1 y=2\nstatus\nmark \"b\"\nclear\nmark \"c\"\n";
  recording::Trace trace = recorded(protocol::assemble(text), 1000);
  CHECK_FALSE(departure(trace));
  auto& data = std::get<recording::Data>(trace.records[1]);
  std::string changed = text;
  changed[changed.find("y=2") + 2] = '3';
  data.bytes = protocol::assemble(changed);
  const auto found = departure(trace);
  REQUIRE(found);
  CHECK(found->number == 5);
  CHECK(found->recorded.commands == 5);
  CHECK(found->agreed == 2U);
}

TEST_CASE("a state that counts commands which are not there, or not there yet, is none that was come to") {
  const std::uint32_t sum = device::state_checksum({});
  const recording::Record clear = recording::Data{protocol::assemble("clear\n")};
  recording::Trace trace;
  SECTION("at the end") { trace.records = {clear, State{2, sum}}; }
  SECTION("before its data") { trace.records = {clear, State{2, sum}, clear}; }
  SECTION("of a command before the last that was noted") {
    trace.records = {clear, clear, State{2, sum}, State{1, sum}};
  }
  const auto found = departure(trace);
  REQUIRE(found);
  CHECK(found->recorded.commands != found->number);
}

TEST_CASE("states are compared where that is asked for alone") {
  recording::Trace trace;
  trace.records = {State{0, 1}, recording::Data{protocol::assemble("clear\n")}, State{1, 1}};
  recording::Walk walk(trace);
  while (walk.next()) continue;
  CHECK_FALSE(walk.departure());
  recording::Walk comparing(trace, recording::States::compared);
  CHECK(comparing.departure()); // that of the beginning already
}
