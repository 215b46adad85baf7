#include "hand_made.h"
#include "support/scratch.h"

#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace halftone;
using test::Bytes;
using test::ColorType;
using test::encode;
using test::HandMade;
using test::save;

namespace {

png::Picture read(const Bytes& bytes) {
  const test::Scratch folder;
  save(folder.path() / "a.png", bytes);
  return png::read(folder.path() / "a.png");
}

std::string refusal(const Bytes& bytes) {
  try {
    read(bytes);
  } catch (const png::ReadError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::uint16_t> random_samples(std::size_t count, int depth, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint16_t> samples(count);
  for (auto& sample : samples) sample = static_cast<std::uint16_t>(random() % (std::uint64_t{1} << depth));
  return samples;
}

/// A sample of any depth as 8 bits, by the specification's formula.
std::uint8_t to_8_bits(std::uint16_t sample, int depth) {
  const unsigned most = (1U << depth) - 1;
  return static_cast<std::uint8_t>((sample * 255U + most / 2) / most);
}

} // namespace

TEST_CASE("grey, colour and alpha of every depth, interlaced or not, are read as 8-bit RGB without alpha") {
  struct Kind {
    ColorType type;
    std::size_t channels;
    std::vector<int> depths;
  };
  const std::vector<Kind> kinds{{ColorType::grey, 1, {1, 2, 4, 8, 16}},
                                {ColorType::rgb, 3, {8, 16}},
                                {ColorType::grey_alpha, 2, {8, 16}},
                                {ColorType::rgb_alpha, 4, {8, 16}}};
  for (const Kind& kind : kinds) {
    for (const int depth : kind.depths) {
      for (const bool interlaced : {false, true}) {
        const HandMade made{.width = 13,
                            .height = 11,
                            .depth = static_cast<std::uint8_t>(depth),
                            .type = kind.type,
                            .interlaced = interlaced,
                            .samples = random_samples(13 * 11 * kind.channels, depth, 1)};
        const png::Picture picture = read(encode(made));
        INFO("colour type " << int(kind.type) << ", depth " << depth << ", interlaced " << interlaced);
        REQUIRE(picture.width == 13);
        REQUIRE(picture.height == 11);
        REQUIRE(picture.rgb.size() == 13 * 11 * 3);
        for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
          const std::size_t channel = kind.channels < 3 ? 0 : i % 3;
          const std::uint16_t sample = made.samples[i / 3 * kind.channels + channel];
          INFO("sample " << i << ", made as " << sample);
          REQUIRE(picture.rgb[i] == to_8_bits(sample, depth));
        }
      }
    }
  }
}

TEST_CASE("palettes of every depth are read as their colours, transparent or not") {
  for (const int depth : {1, 2, 4, 8}) {
    HandMade made{
        .width = 13, .height = 11, .depth = static_cast<std::uint8_t>(depth), .type = ColorType::palette};
    made.samples = random_samples(13 * 11, depth, 2);
    for (int i = 0; i < 3 << depth; ++i) made.palette.push_back(static_cast<std::uint8_t>(i * 37));
    made.transparency = {0, 128};
    const png::Picture picture = read(encode(made));
    INFO("depth " << depth);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
      REQUIRE(picture.rgb[i] == made.palette[std::size_t{3} * made.samples[i / 3] + i % 3]);
    }
  }
}

TEST_CASE("a colour that is marked as transparent is read like any other") {
  const HandMade made{
      .width = 2, .height = 1, .samples = {1, 2, 3, 4, 5, 6}, .transparency = {0, 1, 0, 2, 0, 3}};
  CHECK(read(encode(made)).rgb == Bytes{1, 2, 3, 4, 5, 6});
}

TEST_CASE("samples are taken as they are, whatever gamma the file states") {
  const HandMade made{
      .width = 2, .height = 1, .samples = {1, 50, 100, 150, 200, 250}, .gamma = {0, 1, 0x86, 0xA0}};
  CHECK(read(encode(made)).rgb == Bytes{1, 50, 100, 150, 200, 250});
}

TEST_CASE("a file that is cut off anywhere is refused") {
  const Bytes whole = encode({.width = 9, .height = 7, .samples = random_samples(9 * 7 * 3, 8, 3)});
  // The last chunk is only a mark of the end, and its checksum covers nothing but its name.
  for (std::size_t size = 0; size + 4 < whole.size(); ++size) {
    INFO(size << " bytes of " << whole.size());
    CHECK_THROWS_AS(read(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
                    png::ReadError);
  }
}

TEST_CASE("a file with a wrong byte anywhere is refused or gives the right picture") {
  const Bytes whole = encode({.width = 9, .height = 7, .samples = random_samples(9 * 7 * 3, 8, 4)});
  const png::Picture right = read(whole);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes wrong = whole;
    wrong[i] = static_cast<std::uint8_t>(wrong[i] ^ 0x10);
    INFO("byte " << i);
    png::Picture picture = right;
    try {
      picture = read(wrong);
    } catch (const png::ReadError&) {
      ++refused;
    }
    CHECK((picture == right));
  }
  CHECK(refused > whole.size() / 2);
}

TEST_CASE("sides that are too long are refused before memory is taken for them") {
  const auto sized = [](std::uint32_t width, std::uint32_t height) {
    return encode({.width = width, .height = height, .type = ColorType::grey});
  };
  CHECK(refusal(sized(8193, 1)) != "no error");
  CHECK(refusal(sized(1, 8193)) != "no error");
  CHECK(refusal(sized(0x7FFFFFFF, 0x7FFFFFFF)) != "no error");
  CHECK(refusal(sized(0, 5)) != "no error");
  const HandMade longest{
      .width = 8192, .height = 1, .type = ColorType::grey, .samples = std::vector<std::uint16_t>(8192)};
  CHECK(read(encode(longest)).width == 8192);
}

TEST_CASE("what cannot be read is refused by its name") {
  const test::Scratch folder;
  CHECK_THROWS_WITH(png::read(folder.path() / "none.png"),
                    (folder.path() / "none.png").string() + ": No such file or directory");
  CHECK_THROWS_WITH(png::read(folder.path()), folder.path().string() + ": is a folder");
  save(folder.path() / "text.png", {'h', 'e', 'l', 'l', 'o', ' ', 't', 'h', 'e', 'r', 'e'});
  CHECK_THROWS_WITH(png::read(folder.path() / "text.png"),
                    Catch::StartsWith((folder.path() / "text.png").string() + ": ") &&
                        Catch::Contains("PNG"));
}
