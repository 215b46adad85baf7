#include "support/scratch.h"

#include <halftone/link/link.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
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

TEST_CASE("a file link writes over what was there, and writes what is sent") {
  const test::Scratch scratch;
  const std::string path = scratch.write("f", std::string(100, 'o'));
  const auto link = link::open("file:" + path);
  CHECK_FALSE(link->has_way_back());
  CHECK(test::contents(path).empty());
  const std::string much(1'000'000, 'x');
  link->send(span_of("one "));
  link->send(span_of(much));
  CHECK((test::contents(path) == "one " + much));
  std::uint8_t byte = 0;
  CHECK_THROWS_WITH(link->receive({&byte, 1}, 10s), path + " has no way back");
}

TEST_CASE("a file that cannot be written is an error that names it, and no wait") {
  const test::Scratch scratch;
  const auto refused = [](const std::string& path, const std::string& why) {
    CHECK_THROWS_AS(link::open("file:" + path), link::DeviceError);
    CHECK_THROWS_WITH(link::open("file:" + path), path + ": cannot be written: " + why);
  };
  refused(scratch / "none/f", "No such file or directory");
  refused(scratch.path().string(), "Is a directory");
  refused("/dev/null", "it is not a regular file");
  REQUIRE(::mkfifo((scratch / "fifo").c_str(), 0600) == 0);
  refused(scratch / "fifo", "No such device or address"); // no reader
}

TEST_CASE("a disk that is full is an error") {
  if (::access("/dev/full", W_OK) != 0) {
    WARN("skipped: no /dev/full here");
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
