#include "support/full_disk.h"
#include "support/scratch.h"

#include <halftone/file/write.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

using namespace halftone;
using test::contents;
using test::Scratch;

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  file::write_whole(file, std::as_bytes(std::span(text)));
}

} // namespace

TEST_CASE("a file has the bytes that were written, whatever it had before, and nothing is left beside it") {
  const Scratch folder;
  for (const std::string& text : {std::string("one"), std::string(1'000'000, 'x'), std::string()}) {
    write(folder / "f", text);
    CHECK((contents(folder / "f") == text));
    CHECK(folder.names() == std::vector<std::string>{"f"});
  }
}

TEST_CASE("where the disk is full, the old file stays and no new one does") {
  const Scratch folder;
  write(folder / "f", "old");
  for (const rlim_t size : {0, 10, 100'000}) {
    const test::FullDisk full(size);
    CHECK_THROWS_AS(write(folder / "f", std::string(200'000, 'x')), file::WriteError);
    CHECK_THROWS_WITH(write(folder / "g", std::string(200'000, 'x')),
                      folder / "g" + ": cannot be written: File too large");
  }
  CHECK(contents(folder / "f") == "old");
  CHECK(folder.names() == std::vector<std::string>{"f"});
}

TEST_CASE("what cannot be written is refused by its name, before as well as when it is written") {
  const Scratch folder;
  const auto refused = [](const std::string& file, const std::string& before, const std::string& when) {
    CHECK_THROWS_AS(file::check_writable(file), file::WriteError);
    CHECK_THROWS_WITH(file::check_writable(file), file + ": cannot be written: " + before);
    CHECK_THROWS_WITH(write(file, "x"), file + ": cannot be written: " + when);
  };
  const std::string none = folder / "none";
  refused(none + "/f", "the folder " + none + " does not exist", "No such file or directory");
  refused(folder.path().string(), "it is a folder", "it is a folder");
  refused(folder / "", "expected the name of a file", "expected the name of a file");
  refused("/dev/null", "it is not a regular file", "it is not a regular file");
  CHECK(std::filesystem::is_character_file("/dev/null"));
  std::filesystem::create_symlink("nothing", folder / "link");
  refused(folder / "link", "it is a link to nothing", "it is a link to nothing");
  CHECK_NOTHROW(file::check_writable(folder / "f"));
  CHECK(folder.names() == std::vector<std::string>{"link"});
}
