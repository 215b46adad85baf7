#include <halftone/png/compare.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace halftone;
using png::Picture;

namespace {

Picture grey(int width, int height, std::uint8_t level) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3, level)};
}

std::uint8_t& sample(Picture& picture, int x, int y, int channel) {
  return picture.rgb[static_cast<std::size_t>((y * picture.width + x) * 3 + channel)];
}

} // namespace

TEST_CASE("equal pictures do not differ") {
  const auto difference = png::compare(grey(5, 4, 77), grey(5, 4, 77));
  CHECK(difference.rmse == 0);
  CHECK(difference.largest == 0);
  CHECK(difference.percentile_999 == 0);
  CHECK(difference.share_over_1 == 0);
}

TEST_CASE("one wrong sample gives its size, its place and its share") {
  const Picture a = grey(5, 4, 100);
  Picture b = a;
  sample(b, 3, 2, 1) = 90;
  for (const auto& difference : {png::compare(a, b), png::compare(b, a)}) {
    CHECK(difference.rmse == Approx(std::sqrt(100.0 / 60)));
    CHECK(difference.largest == 10);
    CHECK(difference.largest_x == 3);
    CHECK(difference.largest_y == 2);
    CHECK(difference.percentile_999 == 10);
    CHECK(difference.share_over_1 == Approx(1.0 / 20));
    CHECK(difference.share_over_4 == Approx(1.0 / 20));
    CHECK(difference.share_over_16 == 0);
  }
}

TEST_CASE("of several largest differences the first in reading order is named") {
  const Picture a = grey(5, 4, 100);
  Picture b = a;
  sample(b, 4, 1, 2) = 130;
  sample(b, 0, 2, 0) = 70;
  const auto difference = png::compare(a, b);
  CHECK(difference.largest_x == 4);
  CHECK(difference.largest_y == 1);
}

TEST_CASE("shares count pixels above a level, not at it") {
  const Picture a = grey(4, 1, 100);
  Picture b = a;
  sample(b, 0, 0, 0) = 101;
  sample(b, 1, 0, 0) = 104;
  sample(b, 2, 0, 0) = 116;
  sample(b, 3, 0, 0) = 117;
  const auto difference = png::compare(a, b);
  CHECK(difference.share_over_1 == 0.75);
  CHECK(difference.share_over_4 == 0.5);
  CHECK(difference.share_over_16 == 0.25);
}

TEST_CASE("the 99.9th percentile lets one pixel in a thousand be worse") {
  const Picture a = grey(100, 10, 100);
  Picture b = a;
  sample(b, 50, 5, 0) = 200;
  CHECK(png::compare(a, b).percentile_999 == 0);
  sample(b, 51, 5, 0) = 103;
  CHECK(png::compare(a, b).percentile_999 == 3);
}

TEST_CASE("the percentile is that of the sorted differences") {
  std::mt19937_64 random(1);
  for (int run = 0; run < 200; ++run) {
    const int width = 1 + static_cast<int>(random() % 90), height = 1 + static_cast<int>(random() % 90);
    Picture a = grey(width, height, 0), b = a;
    std::vector<int> largest;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
      const int d = static_cast<int>(random() % 64 == 0 ? random() % 256 : random() % 3);
      a.rgb[i + random() % 3] = static_cast<std::uint8_t>(d);
      largest.push_back(d);
    }
    std::ranges::sort(largest);
    const std::size_t rank = (largest.size() * 999 + 999) / 1000; // ceil(0.999 n), from 1
    INFO("seed 1, run " << run << ", " << width << " x " << height);
    CHECK(png::compare(a, b).percentile_999 == largest[rank - 1]);
  }
}

TEST_CASE("a difference picture is grey where the pictures are equal, and brighter where the first is") {
  const Picture a = grey(2, 1, 100);
  Picture b = a;
  sample(b, 0, 0, 0) = 98;
  sample(b, 0, 0, 1) = 101;
  sample(b, 1, 0, 0) = 0;
  sample(b, 1, 0, 2) = 255;
  CHECK(png::difference_picture(a, b).rgb == std::vector<std::uint8_t>{144, 120, 128, 255, 128, 0});
  CHECK(png::difference_picture(a, b, 1).rgb == std::vector<std::uint8_t>{130, 127, 128, 228, 128, 0});
}

TEST_CASE("pictures of different sizes, or without pixels, are not compared") {
  CHECK_THROWS_WITH(png::compare(grey(2, 3, 0), grey(3, 2, 0)),
                    "the pictures differ in size: 2 x 3 and 3 x 2");
  CHECK_THROWS_AS(png::difference_picture(grey(2, 3, 0), grey(2, 4, 0)), std::invalid_argument);
  CHECK_THROWS_AS(png::compare({}, {}), std::invalid_argument);
}
