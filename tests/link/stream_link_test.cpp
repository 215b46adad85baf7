#include "support/skip.h"

#include <halftone/link/link.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <string>

#include <fcntl.h>
#include <unistd.h>

using namespace halftone;
using namespace std::chrono_literals;

namespace {

std::span<const std::uint8_t> span_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

/// Standard output is this descriptor while it lives.
class AsOutput {
public:
  explicit AsOutput(int number) : before_(::dup(STDOUT_FILENO)) { ::dup2(number, STDOUT_FILENO); }
  ~AsOutput() {
    ::dup2(before_, STDOUT_FILENO);
    ::close(before_);
  }
  AsOutput(const AsOutput&) = delete;
  AsOutput& operator=(const AsOutput&) = delete;

private:
  int before_;
};

/// What goes wrong when these bytes are sent to standard output, which is the given descriptor; empty:
/// nothing.
std::string trouble(int output, const std::string& bytes) {
  try {
    const AsOutput as_output(output);
    link::open("pipe:", 100ms)->send(span_of(bytes));
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST_CASE("a disk that is full is an error") {
  if (::access("/dev/full", W_OK) != 0) {
    test::skip_anywhere("no /dev/full here");
    return;
  }
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  CHECK(trouble(full, "x") == "standard output cannot be written: No space left on device");
  ::close(full);
}

TEST_CASE("a pipe link writes to standard output; a reader that is gone or asleep is an error, no signal") {
  std::array<int, 2> ends{};
  REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
  CHECK(trouble(ends[1], "hello").empty());
  std::array<char, 10> buffer{};
  CHECK(::read(ends[0], buffer.data(), buffer.size()) == 5);
  CHECK(trouble(ends[1], std::string(1'000'000, 'x')) == "standard output took nothing for 100 ms");
  ::close(ends[0]);
  CHECK(trouble(ends[1], "x") == "standard output: the program that reads it has ended");
  ::close(ends[1]);
}
