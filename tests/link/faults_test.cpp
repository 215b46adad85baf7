#include <halftone/link/faulty_link.h>

#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;
using link::Faults;

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Result {
  Bytes bytes;
  std::size_t faults = 0;
  bool closed = false;
  bool restarted = false;
  std::chrono::milliseconds delay{0};
};

/// A million bytes through the cable, in pieces of this size.
Result pass(const Faults& faults, std::size_t piece) {
  link::FaultyCable cable(faults);
  Result result;
  const Bytes all(1'000'000, 'x');
  for (std::span<const std::uint8_t> rest = all; !rest.empty();) {
    const std::size_t size = std::min(piece, rest.size());
    const link::Passed passed = cable.pass(rest.first(size));
    rest = rest.subspan(size);
    result.bytes.insert(result.bytes.end(), passed.bytes.begin(), passed.bytes.end());
    result.closed = result.closed || passed.closed;
    result.restarted = result.restarted || passed.restarted;
    result.delay += passed.delay;
  }
  result.faults = cable.count();
  return result;
}

} // namespace

TEST_CASE("a cable without faults passes everything") {
  const Result result = pass({}, 1000);
  CHECK((result.bytes == Bytes(1'000'000, 'x')));
  CHECK(result.faults == 0);
}

TEST_CASE("faults are the same for the same seed, however the bytes are cut, and come as often as asked") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Faults faults{.seed = seed, .flipped = 5000, .dropped = 5000, .delayed = 5000};
    INFO(link::describe(faults));
    const Result result = pass(faults, 1000), other = pass(faults, 77), next = pass({seed + 1, 5000}, 1000);
    CHECK((result.bytes == other.bytes));
    CHECK(result.delay == other.delay);
    CHECK(result.faults == other.faults);
    CHECK((result.bytes != next.bytes));
    CHECK(result.faults > 500); // of 600 that are expected, fewer by the flips in what is dropped
    CHECK(result.faults < 700);
    CHECK(result.delay > 500ms);
  }
}

TEST_CASE("after its last byte a cable passes nothing") {
  for (const std::size_t last : {0, 1, 999, 1000, 500'000}) {
    const Result result = pass({.closed_after = last}, 1000);
    CHECK(result.bytes.size() == last);
    CHECK(result.closed);
  }
}

TEST_CASE("a restart loses the rest of the piece") {
  const Result result = pass({.restarted_after = 2500}, 1000);
  CHECK(result.bytes.size() == 999'500);
  CHECK(result.restarted);
}

TEST_CASE("the seeds of fault injection give every kind of fault, and none") {
  int flipped = 0, dropped = 0, truncated = 0, delayed = 0, closed = 0, restarted = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Faults faults = link::faults_of(seed);
    const auto count = [](std::size_t bytes, int& sum) { sum += bytes != link::never ? 1 : 0; };
    count(faults.flipped, flipped);
    count(faults.dropped, dropped);
    count(faults.truncated, truncated);
    count(faults.delayed, delayed);
    count(faults.closed_after, closed);
    count(faults.restarted_after, restarted);
    none += link::describe(faults) == "seed " + std::to_string(seed) ? 1 : 0;
  }
  for (const int kind : {flipped, dropped, truncated, delayed, closed, restarted, none}) CHECK(kind > 20);
}

TEST_CASE("a faulty link without faults is the link that it is over") {
  const auto link = link::open_faulty_link({}, [] { return link::open("mem:"); });
  Bytes query;
  append(query, protocol::Message{protocol::Opcode::identify, 1, {}, {}});
  link->send(query);
  Bytes buffer(100);
  CHECK(link->receive(buffer, 1ms) > 20);
}

TEST_CASE("what arrives before a faulty link is closed is received, and then the link is closed for good") {
  Bytes query;
  append(query, protocol::Message{protocol::Opcode::identify, 1, {}, {}});
  const auto link =
      link::open_faulty_link({.closed_after = query.size() + 5}, [] { return link::open("mem:"); });
  link->send(query);
  Bytes buffer(100);
  CHECK(link->receive(buffer, 1ms) == 5);
  CHECK_THROWS_AS(link->receive(buffer, 1ms), link::DeviceError);
  CHECK_THROWS_AS(link->send(query), link::DeviceError);
}

TEST_CASE("a device behind a faulty link that restarts has forgotten what it was told") {
  const auto sum_after = [](std::size_t restart) {
    const auto link = link::open_faulty_link({.restarted_after = restart}, [] { return link::open("mem:"); });
    Bytes commands;
    append(commands, protocol::Message{protocol::Opcode::fill, 1, {0, 0, 1, 1, 9, 9, 9}, {}});
    link->send(commands);
    commands.clear();
    append(commands, protocol::Message{protocol::Opcode::mark, 2, {}, Bytes{'x'}});
    link->send(commands);
    commands.clear();
    append(commands, protocol::Message{protocol::Opcode::checksum, 3, {0, 0, 1, 1}, {}});
    link->send(commands);
    Bytes answer(17);
    REQUIRE(link->receive(answer, 1ms) == 17);
    return answer;
  };
  Bytes black;
  append(black, protocol::Message{protocol::Opcode::sum, 3, {0xFF41D912}, {}}); // of three zeros
  CHECK(sum_after(30) == black);
  CHECK(sum_after(link::never) != black);
}
