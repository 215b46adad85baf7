#include "hand_made.h"
#include "support/full_disk.h"
#include "support/scratch.h"

#include <halftone/file/write.h>
#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace halftone;
using test::Bytes;

namespace {

png::Picture noise(int width, int height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  png::Picture picture{width, height, Bytes(static_cast<std::size_t>(width) * height * 3)};
  for (auto& byte : picture.rgb) byte = static_cast<std::uint8_t>(random());
  return picture;
}

bool contains(const Bytes& file, const Bytes& part) {
  return std::search(file.begin(), file.end(), part.begin(), part.end()) != file.end();
}

} // namespace

TEST_CASE("a picture is read as it was written, and nothing else is left in the folder") {
  const test::Scratch folder;
  for (const auto encoding : {png::Encoding::srgb, png::Encoding::linear}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {512, 512}, {7, 300}, {8192, 1}}) {
      const auto picture = noise(width, height, 1);
      png::write(folder.path() / "a.png", picture, encoding);
      INFO(width << " x " << height);
      CHECK((png::read(folder.path() / "a.png") == picture));
      CHECK(folder.names() == std::vector<std::string>{"a.png"});
    }
  }
}

TEST_CASE("an sRGB picture is marked so, a linear one has gamma 1") {
  const test::Scratch folder;
  const auto written = [&](png::Encoding encoding) {
    png::write(folder.path() / "a.png", noise(3, 3, 2), encoding);
    return test::load(folder.path() / "a.png");
  };
  const Bytes srgb = test::chunk("sRGB", {0}), gamma_1 = test::chunk("gAMA", {0, 1, 0x86, 0xA0});
  CHECK(contains(written(png::Encoding::srgb), srgb));
  CHECK(!contains(written(png::Encoding::srgb), {'g', 'A', 'M', 'A'}));
  CHECK(contains(written(png::Encoding::linear), gamma_1));
  CHECK(!contains(written(png::Encoding::linear), {'s', 'R', 'G', 'B'}));
}

TEST_CASE("the same picture gives the same bytes") {
  const test::Scratch folder;
  png::write(folder.path() / "a.png", noise(50, 40, 3), png::Encoding::srgb);
  png::write(folder.path() / "b.png", noise(50, 40, 3), png::Encoding::srgb);
  CHECK((test::load(folder.path() / "a.png") == test::load(folder.path() / "b.png")));
}

TEST_CASE("where the disk fills up, the old picture stays and no temporary file does") {
  const test::Scratch folder;
  const auto old_picture = noise(10, 10, 4);
  png::write(folder.path() / "a.png", old_picture, png::Encoding::srgb);
  for (const rlim_t size : {0, 10, 1000, 10'000}) { // the last ones fail when buffers are written
    const test::FullDisk full(size);
    INFO("full after " << size << " bytes");
    CHECK_THROWS_AS(png::write(folder.path() / "a.png", noise(200, 200, 5), png::Encoding::srgb),
                    file::WriteError);
    CHECK_THROWS_AS(png::write(folder.path() / "b.png", noise(100, 100, 5), png::Encoding::srgb),
                    file::WriteError);
  }
  { // small enough to be written only when the file is closed
    const test::FullDisk full(100);
    CHECK_THROWS_AS(png::write(folder.path() / "a.png", noise(20, 20, 5), png::Encoding::srgb),
                    file::WriteError);
  }
  CHECK((png::read(folder.path() / "a.png") == old_picture));
  CHECK(folder.names() == std::vector<std::string>{"a.png"});
}

TEST_CASE("what cannot be written is refused by its name") {
  const test::Scratch folder;
  const auto refused = [](const std::filesystem::path& file, const std::string& reason) {
    CHECK_THROWS_AS(png::write(file, noise(2, 2, 6), png::Encoding::srgb), file::WriteError);
    CHECK_THROWS_WITH(png::write(file, noise(2, 2, 6), png::Encoding::srgb),
                      Catch::StartsWith(file.string() + ": ") && Catch::Contains(reason));
  };
  refused(folder.path() / "no" / "folder.png", "No such file or directory");
  refused(folder.path(), "it is a folder");
  refused("/dev/null", "it is not a regular file");
  CHECK(std::filesystem::is_character_file("/dev/null"));
  CHECK(folder.names().empty());
}

TEST_CASE("a picture without pixels, too large, or with pixels missing is refused") {
  const test::Scratch folder;
  const auto file = folder.path() / "a.png";
  CHECK_THROWS_AS(png::write(file, {}, png::Encoding::srgb), file::WriteError);
  CHECK_THROWS_AS(png::write(file, noise(8193, 1, 7), png::Encoding::srgb), file::WriteError);
  CHECK_THROWS_AS(png::write(file, {2, 2, Bytes(11)}, png::Encoding::srgb), file::WriteError);
  CHECK_THROWS_AS(png::write(file, {-2, -2, Bytes(12)}, png::Encoding::srgb), file::WriteError);
  CHECK(folder.names().empty());
}
