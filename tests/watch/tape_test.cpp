#include <halftone/watch/tape.h>

#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <iterator>
#include <thread>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;

namespace {

std::chrono::steady_clock::time_point in(std::chrono::milliseconds time) {
  return std::chrono::steady_clock::now() + time;
}

} // namespace

TEST_CASE("a tape brings all records from one thread to another, in order") {
  watch::Tape tape;
  const std::jthread recorder([&] {
    recording::Writer writer([&](std::span<const std::uint8_t> bytes) { tape.append(bytes); },
                             device::Device());
    for (std::uint8_t i = 0; i < 200; ++i) writer.data(std::vector(10, i));
  });
  std::vector<recording::Record> records;
  const auto end = in(10s);
  while (records.size() < 200 && std::chrono::steady_clock::now() < end)
    std::ranges::move(tape.take(in(100ms)), std::back_inserter(records));
  REQUIRE(records.size() == 200);
  for (std::size_t i = 0; i < 200; ++i)
    REQUIRE(records[i] == recording::Record(recording::Data{std::vector(10, static_cast<std::uint8_t>(i))}));
}

TEST_CASE("whoever waits for a tape is woken by time, records, or a call") {
  watch::Tape tape;
  const auto start = std::chrono::steady_clock::now();
  CHECK(tape.take(in(20ms)).empty());
  CHECK(std::chrono::steady_clock::now() - start >= 20ms);
  const std::jthread other([&] {
    std::this_thread::sleep_for(20ms);
    tape.wake();
  });
  CHECK(tape.take(in(60s)).empty());
  CHECK(std::chrono::steady_clock::now() - start < 30s);
}
