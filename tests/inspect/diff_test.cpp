#include "streams.h"

#include <halftone/inspect/diff.h>

#include <halftone/device/device.h>

#include <catch2/catch.hpp>

#include <list>

using namespace halftone;
using inspect::Comparison;
using inspect::Difference;
using test::Bytes;
using test::Random;

namespace {

/// A command with its bytes, kept.
struct Kept {
  std::uint64_t number;
  protocol::Item item;
  Bytes data;
};

/// All commands that change something.
std::list<Kept> compared(const recording::Trace& trace, const Comparison& comparison) {
  std::list<Kept> all;
  recording::Walk walk(trace);
  while (const auto step = walk.next()) {
    const protocol::Message* message = inspect::message_of(*step);
    if (message != nullptr && (inspect::is_query(*message) || message->opcode == protocol::Opcode::mark ||
                               (comparison.ignore_clock && message->opcode == protocol::Opcode::wait)))
      continue;
    all.push_back({step->number, step->item, {}});
    if (message == nullptr) continue;
    all.back().data.assign(message->data.begin(), message->data.end());
    std::get<protocol::Message>(all.back().item.content).data = all.back().data;
  }
  return all;
}

/// The numbers of the commands after which whole devices differ, 0 for a recording that has ended.
std::optional<std::pair<std::uint64_t, std::uint64_t>> parting(const recording::Trace& a,
                                                               const recording::Trace& b) {
  const Comparison comparison{true};
  const auto of_a = compared(a, comparison), of_b = compared(b, comparison);
  device::Device device_a, device_b;
  Bytes replies;
  for (auto i = of_a.begin(), j = of_b.begin(); i != of_a.end() || j != of_b.end();) {
    std::pair<std::uint64_t, std::uint64_t> numbers{0, 0};
    if (i != of_a.end()) device_a.execute(i->item, replies), numbers.first = (i++)->number;
    if (j != of_b.end()) device_b.execute(j->item, replies), numbers.second = (j++)->number;
    device_b.registers.commands = device_a.registers.commands;
    device_b.clock = device_a.clock;
    if (device_a != device_b) return numbers;
  }
  return std::nullopt;
}

/// The stream with queries and marks put in, and perhaps a change.
Bytes varied(Random& random, const Bytes& stream) {
  Bytes result;
  std::span<const std::uint8_t> bytes = stream;
  protocol::Decoder decoder(protocol::Direction::to_device);
  const auto changed = random() % 14;
  for (std::uint64_t number = 0; const auto item = decoder.next(bytes); ++number) {
    auto message = std::get<protocol::Message>(item->content);
    if (random() % 4 == 0) append(result, protocol::Message{protocol::Opcode::status, 0, {}, {}});
    if (random() % 4 == 0) append(result, protocol::Message{protocol::Opcode::mark, 0, {}, Bytes{'m'}});
    if (number != changed) {
      append(result, message);
      continue;
    }
    switch (random() % 3) {
    case 0:
      break; // left out
    case 1: {
      Bytes data(message.data.begin(), message.data.end());
      if (!data.empty()) data[random() % data.size()] ^= 1;
      message.data = data;
      append(result, message);
      break;
    }
    default:
      append(result, message);
      append(result, test::random_message(random, protocol::Direction::to_device).message);
    }
  }
  return result;
}

} // namespace

TEST_CASE("recordings part where devices that are compared whole after every command differ") {
  std::size_t different = 0, equal = 0;
  for (std::uint64_t seed = 300; seed < 400; ++seed) {
    Random random(seed);
    const Bytes stream = test::random_stream(random);
    const recording::Trace a = test::trace_of(stream), b = test::trace_of(varied(random, stream));
    const auto expected = parting(a, b);
    const auto found = inspect::diff(a, b, {true});
    INFO("seed " << seed);
    REQUIRE(found.has_value() == expected.has_value());
    if (!found) {
      ++equal;
      continue;
    }
    ++different;
    REQUIRE((found->a ? found->a->number : 0) == expected->first);
    REQUIRE((found->b ? found->b->number : 0) == expected->second);
    REQUIRE_FALSE(found->differences.empty());
    const auto swapped = inspect::diff(b, a, {true});
    REQUIRE(swapped);
    REQUIRE(swapped->step == found->step);
  }
  CHECK(different > 20);
  CHECK(equal > 20);
}

TEST_CASE("a difference of pixels names the first, how many there are and where they lie") {
  const std::string same =
      "window x=0 y=0 width=8 height=8\nfill x=1 y=1 width=9 height=9 red=1 green=1 blue=1\n";
  const auto found = inspect::diff(
      test::trace_of_text(same + "fill x=4 y=5 width=3 height=2 red=10 green=20 blue=30\n"),
      test::trace_of_text(same + "status\nfill x=4 y=6 width=3 height=2 red=10 green=20 blue=31\n"), {true});
  REQUIRE(found);
  CHECK(found->step == 3);
  CHECK(found->a->number == 3);
  CHECK(found->b->number == 4);
  CHECK(found->b->text == "fill x=4 y=6 width=3 height=2 red=10 green=20 blue=31");
  REQUIRE(found->differences.size() == 1);
  const Difference& pixels = found->differences[0];
  CHECK(pixels.part == Difference::Part::pixels);
  CHECK(pixels.name == "image0");
  CHECK(pixels.x == 4);
  CHECK(pixels.y == 5);
  CHECK(pixels.a == "10 20 30");
  CHECK(pixels.b == "1 1 1");
  CHECK(pixels.count == 9);
  CHECK(pixels.bounds == device::Rectangle{4, 5, 3, 3});
}

TEST_CASE("differences of tables and settings are named") {
  const auto first = [](const std::string& a, const std::string& b) {
    const auto found = inspect::diff(test::trace_of_text(a), test::trace_of_text(b), {true});
    REQUIRE(found);
    return found->differences.at(0);
  };
  const Difference lut = first("lut channels=2 first=7 09\n", "lut channels=2 first=6 09\n");
  CHECK(lut.part == Difference::Part::lut);
  CHECK(lut.name == "green");
  CHECK(lut.x == 6);
  CHECK(lut.count == 2);
  const Difference pan = first("pan x=1 y=2\n", "pan x=1 y=3\n");
  CHECK(pan.part == Difference::Part::setting);
  CHECK(pan.name == "pan");
  CHECK(pan.a == "1 2");
  CHECK(pan.b == "1 3");
  CHECK(first("overlay_fill x=3 y=4 width=2 height=1 value=1\n", "clear\n").name == "overlay");
  CHECK(first("frame 0x7f\n", "clear\n").name == "error");
}

TEST_CASE("queries and marks are left out, and their time is if the clock is ignored") {
  const recording::Trace a = test::trace_of_text("clear\n"),
                         b = test::trace_of_text("mark \"x\"\nstatus\nclear\n");
  CHECK_FALSE(inspect::diff(a, b, {true}));
  const auto found = inspect::diff(a, b, {false});
  REQUIRE(found);
  CHECK(found->differences.at(0).part == Difference::Part::clock);
  CHECK_FALSE(inspect::diff(test::trace_of_text("wait fields=3\nclear\n"), a, {true}));
}

TEST_CASE("after the end of one recording the other goes on, until something differs") {
  const recording::Trace a = test::trace_of_text("clear\n");
  CHECK_FALSE(inspect::diff(a, test::trace_of_text("clear\nclear\n"), {true}));
  const auto found = inspect::diff(a, test::trace_of_text("clear\nclear\nzoom shift=1\n"), {true});
  REQUIRE(found);
  CHECK_FALSE(found->a);
  CHECK(found->b->number == 3);
}

TEST_CASE("recordings that begin differently part before the first command") {
  recording::Trace a = test::trace_of_text("clear\n"), b = a;
  device::Device device;
  device.registers.zoom = 2;
  b.header.snapshot = recording::pack_state(device);
  const auto found = inspect::diff(a, b, {true});
  REQUIRE(found);
  CHECK(found->step == 0);
  CHECK_FALSE(found->a);
  CHECK(found->differences.at(0).name == "zoom");
}
