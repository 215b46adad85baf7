#include "support/full_disk.h"
#include "support/scratch.h"

#include <halftone/file/write.h>
#include <halftone/link/link.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;

namespace {

std::span<const std::uint8_t> span_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

} // namespace

TEST_CASE("a file link leaves the old file alone until all is sent, and then writes over it") {
  const test::Scratch scratch;
  const std::string path = scratch.write("f", "old");
  const auto link = link::open("file:" + path);
  CHECK_FALSE(link->has_way_back());
  const std::string much(1'000'000, 'x');
  link->send(span_of("one "));
  link->send(span_of(much));
  CHECK(test::contents(path) == "old");
  CHECK(scratch.names() == std::vector<std::string>{"f"});
  link->finish();
  CHECK((test::contents(path) == "one " + much));
  CHECK(scratch.names() == std::vector<std::string>{"f"});
  std::uint8_t byte = 0;
  CHECK_THROWS_WITH(link->receive({&byte, 1}, 10s), path + " has no way back");
}

TEST_CASE("a file that cannot be written is an error that names it, before anything is sent") {
  const test::Scratch scratch;
  const auto refused = [](const std::string& path, const std::string& why) {
    CHECK_THROWS_AS(link::open("file:" + path), file::WriteError);
    CHECK_THROWS_WITH(link::open("file:" + path), path + ": cannot be written: " + why);
  };
  refused(scratch / "none/f", "the folder " + scratch / "none" + " does not exist");
  refused(scratch.path().string(), "it is a folder");
  refused("/dev/null", "it is not a regular file");
}

TEST_CASE("where the disk is full in the end, the old file stays") {
  const test::Scratch scratch;
  const std::string path = scratch.write("f", "old");
  const auto link = link::open("file:" + path);
  link->send(span_of(std::string(1000, 'x')));
  {
    const test::FullDisk full(100);
    CHECK_THROWS_AS(link->finish(), file::WriteError);
  }
  CHECK(test::contents(path) == "old");
  CHECK(scratch.names() == std::vector<std::string>{"f"});
}
