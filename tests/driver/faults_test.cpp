#include "faulty_link.h"
#include "picture.h"

#include <halftone/driver/driver.h>

#include <catch2/catch.hpp>

#include <chrono>

using namespace halftone;
using namespace std::chrono_literals;
using test::Faults;

namespace {

enum class Outcome { right, device_error, timeout };

/// Sends a picture over a faulty link and reads it back; fails the test if what comes back is not what was
/// sent, and nobody said so.
Outcome run(const Faults& faults, const test::TestPicture& picture) {
  test::FaultyLink link(faults);
  driver::Driver driver(link, 500ms);
  const auto start = std::chrono::steady_clock::now();
  INFO(test::describe(faults));
  Outcome outcome = Outcome::right;
  std::vector<std::uint8_t> received = picture.rgb;
  try {
    test::send(driver, picture);
    driver.finish();
    received = driver.read_picture();
  } catch (const link::DeviceError& error) {
    CHECK(*error.what() != '\0');
    outcome = Outcome::device_error;
  } catch (const link::Timeout& timeout) {
    CHECK(*timeout.what() != '\0');
    outcome = Outcome::timeout;
  }
  CHECK((received == picture.rgb));
  CHECK(std::chrono::steady_clock::now() - start < 5s);
  return outcome;
}

struct Count {
  int right = 0;
  int failed = 0;
};

Count run_many(Faults faults, int runs) {
  Count count;
  for (int i = 0; i < runs; ++i) {
    faults.seed = static_cast<std::uint64_t>(i);
    const auto picture = test::noise(1 + i % 64, 1 + i * 7 % 48, faults.seed);
    ++(run(faults, picture) == Outcome::right ? count.right : count.failed);
  }
  return count;
}

} // namespace

TEST_CASE("bytes that are flipped on the way do not show in the picture") {
  CHECK(run_many({.flipped_byte = 3000}, 100).right == 100);
}

TEST_CASE("bytes that are dropped on the way do not show in the picture") {
  CHECK(run_many({.dropped_byte = 3000}, 100).right == 100);
}

TEST_CASE("pieces that are lost or cut off on the way do not show in the picture") {
  CHECK(run_many({.dropped_piece = 20}, 100).right == 100);
  CHECK(run_many({.truncated_piece = 20}, 100).right == 100);
}

TEST_CASE("a link that does all of it at once brings the right picture or an error") {
  const Count rare =
      run_many({.flipped_byte = 5000, .dropped_byte = 5000, .dropped_piece = 50, .truncated_piece = 50}, 100);
  CHECK(rare.right >= 95);
  const Count often =
      run_many({.flipped_byte = 300, .dropped_byte = 300, .dropped_piece = 5, .truncated_piece = 5}, 100);
  CHECK(often.failed > 0); // or this test does not go far enough
}

TEST_CASE("a link that closes at any moment is an error, not a wrong picture") {
  const auto picture = test::noise(20, 10, 1);
  int closed = 0;
  for (std::size_t bytes = 0; bytes < 4000; bytes += 37) {
    if (run({.closes_after = bytes}, picture) == Outcome::device_error) ++closed;
  }
  CHECK(closed > 20);
}

TEST_CASE("a large picture gets through a bad link") {
  const auto picture = test::noise(512, 512, 7);
  CHECK(run({.seed = 7, .flipped_byte = 50'000, .dropped_byte = 50'000}, picture) == Outcome::right);
}
