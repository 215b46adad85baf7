#include "picture.h"

#include <halftone/driver/driver.h>
#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <random>

using namespace halftone;
using test::noise;
using test::send;

namespace {

/// The screen that shows this picture in its middle, black around it.
std::vector<std::uint8_t> screen_of(const test::TestPicture& picture) {
  std::vector<std::uint8_t> screen(512 * 512 * 3);
  for (int y = 0; y < picture.height; ++y) {
    const int left = (512 - picture.width) / 2, top = (512 - picture.height) / 2;
    std::ranges::copy(picture.row(y), screen.begin() + ((top + y) * 512 + left) * 3);
  }
  return screen;
}

} // namespace

TEST_CASE("a picture is centred on the screen, rounded down") {
  const auto is = [](const driver::Placement& place, int left, int top, int width, int height) {
    return place.left == left && place.top == top && place.width == width && place.height == height;
  };
  CHECK(is(driver::centred(512, 512), 0, 0, 512, 512));
  CHECK(is(driver::centred(500, 375), 6, 68, 500, 375));
  CHECK(is(driver::centred(1, 511), 255, 0, 1, 511));
}

TEST_CASE("a picture comes back as it was sent, and the screen around it is black") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  for (const auto& [width, height] :
       {std::pair{512, 512}, {1, 1}, {500, 375}, {3, 511}, {512, 1}, {320, 240}}) {
    INFO(width << " x " << height);
    const auto picture = noise(width, height, 1);
    send(driver, picture);
    driver.finish();
    CHECK((driver.read_picture() == picture.rgb));
    CHECK((driver.read_screen() == screen_of(picture)));
  }
}

TEST_CASE("rows may be sent in any order, and twice") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  const auto picture = noise(40, 30, 2);
  std::vector<int> order(30);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(3);
  for (int run = 0; run < 20; ++run) {
    std::ranges::shuffle(order, random);
    driver.begin(40, 30);
    for (const int y : order) driver.send_row(y, picture.row(y));
    driver.send_row(order[0], picture.row(order[0]));
    driver.finish();
    INFO("seed 3, run " << run);
    CHECK((driver.read_picture() == picture.rgb));
  }
}

TEST_CASE("rows may follow after finish") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  auto picture = noise(40, 30, 4);
  send(driver, picture);
  driver.finish();
  for (int y = 10; y < 12; ++y) {
    const std::vector<std::uint8_t> grey(120, 128);
    std::ranges::copy(grey, picture.rgb.begin() + 120 * y);
    driver.send_row(y, grey);
  }
  driver.finish();
  CHECK((driver.read_picture() == picture.rgb));
}

TEST_CASE("a picture that is begun again starts on a black screen") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  send(driver, noise(512, 512, 5));
  driver.begin(10, 10);
  driver.finish();
  CHECK((driver.read_screen() == std::vector<std::uint8_t>(512 * 512 * 3)));
}

TEST_CASE("a row is held as it was sent last, and black before") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  const auto picture = noise(30, 20, 5), other = noise(30, 20, 6);
  driver.begin(30, 20);
  const std::vector<std::uint8_t> black(90);
  CHECK(driver.holds(7, black));
  CHECK_FALSE(driver.holds(7, picture.row(7)));
  driver.send_row(7, picture.row(7));
  CHECK(driver.holds(7, picture.row(7)));
  CHECK_FALSE(driver.holds(7, other.row(7)));
  CHECK(driver.holds(8, black));
  driver.send_row(7, other.row(7));
  CHECK(driver.holds(7, other.row(7)));
}

TEST_CASE("the driver counts the seconds spent in it") {
  const auto link = link::open("mem:");
  driver::Driver driver(*link);
  CHECK(driver.seconds() == 0);
  driver.begin(512, 512);
  const double begun = driver.seconds();
  CHECK(begun > 0);
  driver.finish();
  CHECK(driver.seconds() > begun);
}

TEST_CASE("the screen is read as it is shown, after a begin that undoes what others did to it") {
  const auto link = link::open("mem:");
  std::vector<std::uint8_t> commands;
  append(commands, protocol::Message{protocol::Opcode::border, 1, {40, 255, 0, 0}, {}});
  append(commands, protocol::Message{protocol::Opcode::zoom, 2, {1}, {}});
  append(commands, protocol::Message{protocol::Opcode::ramp, 3, {7, 0, 256, 255, 0}, {}});
  link->send(commands);
  driver::Driver driver(*link);
  const auto picture = noise(500, 375, 6);
  send(driver, picture);
  driver.finish();
  CHECK((driver.read_screen() == screen_of(picture)));

  commands.clear(); // behind the driver's back
  append(commands, protocol::Message{protocol::Opcode::border, 4, {1, 255, 0, 0}, {}});
  link->send(commands);
  CHECK((driver.read_picture() == picture.rgb));
  CHECK_THROWS_WITH(driver.read_screen(), Catch::Contains("rows 0 to 511 of the screen differ"));
}
