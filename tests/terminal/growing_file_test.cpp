#include "support/full_disk.h"
#include "support/scratch.h"

#include <halftone/file/write.h>
#include <halftone/terminal/growing_file.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace halftone;
using test::contents;
using test::Scratch;

TEST_CASE("what is appended to a growing file is there at once") {
  const Scratch folder;
  folder.write("f", "old");
  terminal::GrowingFile file(folder / "f");
  CHECK(contents(folder / "f").empty());
  std::string expected;
  for (const std::size_t size : {3, 0, 70'000}) {
    const std::vector<std::uint8_t> bytes(size, 'x');
    file.append(bytes);
    expected.append(size, 'x');
    CHECK((contents(folder / "f") == expected));
  }
}

TEST_CASE("what a disk takes in part alone is not in a growing file") {
  const Scratch folder;
  terminal::GrowingFile file(folder / "f");
  const std::vector<std::uint8_t> first(60, 'a'), second(60, 'b'), last(30, 'c');
  file.append(first);
  {
    const test::FullDisk full(100);
    CHECK_THROWS_WITH(file.append(second), folder / "f" + ": cannot be written: File too large");
    CHECK(contents(folder / "f") == std::string(60, 'a'));
    file.append(last);
  }
  file.append(second);
  CHECK(contents(folder / "f") == std::string(60, 'a') + std::string(30, 'c') + std::string(60, 'b'));
}
