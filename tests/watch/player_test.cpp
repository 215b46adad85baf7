#include "../recording/random_trace.h"
#include "support/effort.h"
#include "support/messages.h"

#include <halftone/watch/player.h>

#include <halftone/bus/buses.h>
#include <halftone/device/snapshot.h>
#include <halftone/inspect/who.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>
#include <utility>

using namespace halftone;
using namespace std::chrono_literals;
using protocol::Opcode;
using test::bytes_of;
using watch::Player;

namespace {

const Player::Time start = std::chrono::steady_clock::now();

/// The whole state, but for the bus that times are counted by.
bool agree(const device::Device& a, const device::Device& b) { return device::save(a) == device::save(b); }

/// So many fills, each of another row.
recording::Trace fills(std::uint32_t count) {
  recording::Trace trace;
  for (std::uint32_t i = 0; i < count; ++i)
    trace.records.emplace_back(
        recording::Data{bytes_of({{Opcode::fill, i + 1, {0, i % 512, 512, 1, 1 + i % 255, 2, 3}, {}}})});
  return trace;
}

void advance_to_end(Player& player) {
  while (player.advance(std::chrono::steady_clock::now())) continue;
}

/// Plays all that is due by then.
void settle(Player& player, Player::Time now) {
  std::pair<std::uint64_t, std::uint64_t> before;
  do {
    before = {player.length(), player.position()};
    player.advance(now);
  } while (before != std::pair(player.length(), player.position()));
}

/// Plays all of a recording, and shows none of it yet.
void play_out(Player& player) {
  player.pause();
  std::uint64_t before = 0;
  do {
    before = player.length();
    player.advance(start);
  } while (player.length() != before);
}

device::Bus bus_called(const std::string& name) { return bus::find_bus(bus::built_in(), name); }

} // namespace

TEST_CASE("what is played waits where it is held, and what is further is not held") {
  for (const bool has_bus : {false, true}) {
    CAPTURE(has_bus);
    Player player(fills(100), recording::Trail::ends);
    player.play(has_bus ? std::optional(bus_called("rs232")) : std::nullopt, start);
    player.hold_at(40);
    settle(player, start + 1h);
    CHECK(player.position() == 40);
    CHECK_FALSE(player.is_paused());
    player.seek(60);
    player.play(std::nullopt, start);
    settle(player, start + 1h);
    CHECK(player.position() == 100);
    player.seek(0);
    player.play(std::nullopt, start);
    settle(player, start + 1h);
    CHECK(player.position() == 40);
    player.hold_at(std::nullopt);
    settle(player, start + 1h);
    CHECK(player.position() == 100);
  }
}

TEST_CASE("any place of a recording is what a replay to there comes to") {
  const std::uint64_t seed = 20261;
  test::Random random(seed);
  for (std::uint64_t round = 0; round < 42; round += test::seed_step) {
    const recording::Trace trace = test::random_trace(random);
    Player player(trace, recording::Trail::ends);
    play_out(player);
    for (int i = 0; i < 8; ++i) {
      const std::uint64_t place = std::uniform_int_distribution<std::uint64_t>(0, player.length())(random);
      player.seek(place);
      CAPTURE(seed, round, place, player.length());
      REQUIRE(player.position() == place);
      REQUIRE(agree(player.device(), inspect::device_after(trace, place)));
    }
  }
}

TEST_CASE("a long recording is shown at any place from few snapshots") {
  const recording::Trace trace = fills(5000);
  Player player(trace, recording::Trail::ends);
  CHECK(player.length() == 0); // whoever shows it can answer before it is played
  play_out(player);
  REQUIRE(player.length() == 5000);
  CHECK(player.position() == 0);
  for (const std::uint64_t place : {4999U, 0U, 1U, 3071U, 3072U, 3073U, 2U, 5000U}) {
    player.seek(place);
    CAPTURE(place);
    REQUIRE(agree(player.device(), inspect::device_after(trace, place)));
  }
}

TEST_CASE("a recording that is followed comes to its end while it is played") {
  const recording::Trace trace = fills(5000);
  Player player(trace, recording::Trail::ends);
  player.follow();
  advance_to_end(player);
  CHECK(player.length() == 5000);
  CHECK(player.position() == 5000);
  CHECK(agree(player.device(), inspect::device_after(trace)));
}

TEST_CASE("a stream that grows is followed, whatever pieces it comes in") {
  const std::uint64_t seed = 20262;
  test::Random random(seed);
  for (std::uint64_t round = 0; round < 42; round += test::seed_step) {
    const recording::Trace trace = test::random_trace(random);
    Player player({trace.header, {}, {}, false}, recording::Trail::grows);
    for (const recording::Record& record : trace.records) {
      player.extend({record});
      if (random() % 3 == 0) advance_to_end(player);
    }
    player.extend({recording::SessionEnd{}}); // what is unfinished at a trace's end is damage
    advance_to_end(player);
    CAPTURE(seed, round);
    REQUIRE(player.is_following());
    REQUIRE(agree(player.device(), inspect::device_after(trace)));
  }
}

TEST_CASE("a paused player stands while the stream goes on") {
  const recording::Trace all = fills(100);
  Player player({}, recording::Trail::grows);
  player.extend({all.records.begin(), all.records.begin() + 40});
  advance_to_end(player);
  player.pause();
  player.extend({all.records.begin() + 40, all.records.end()});
  for (int i = 0; i < 100; ++i) CHECK_FALSE(player.advance(start + 1h));
  CHECK(player.position() == 40);
  CHECK(player.length() == 100);
  CHECK(agree(player.device(), inspect::device_after(all, 40)));
  player.follow();
  CHECK(player.position() == 100);
  CHECK(agree(player.device(), inspect::device_after(all)));
}

TEST_CASE("a player that forgets the past shows what others show") {
  const std::uint64_t seed = 20263;
  test::Random random(seed);
  for (std::uint64_t round = 0; round < 42; round += test::seed_step) {
    const recording::Trace trace = test::random_trace(random);
    // Followed, or at the pace of a bus that takes its time.
    for (const bool is_slow : {false, true}) {
      Player player({trace.header, {}, {}, false}, recording::Trail::grows, watch::Past::forgotten);
      Player keeping({trace.header, {}, {}, false}, recording::Trail::grows);
      auto now = start;
      for (Player* each : {&player, &keeping})
        if (is_slow) each->play(bus_called("rs232"), now);
      for (const recording::Record& record : trace.records) {
        player.extend({record});
        keeping.extend({record});
        now += 5ms;
        settle(player, now);
        settle(keeping, now);
        CAPTURE(seed, round, is_slow);
        REQUIRE(player.position() == keeping.position());
        REQUIRE(agree(player.device(), keeping.device()));
      }
      now += 10h;
      settle(player, now);
      settle(keeping, now);
      REQUIRE(agree(player.device(), keeping.device()));
    }
  }
}

TEST_CASE("a past that is forgotten takes no memory") {
  const recording::Trace all = fills(5000);
  for (const bool is_slow : {false, true}) {
    Player player({}, recording::Trail::grows, watch::Past::forgotten);
    if (is_slow) player.play(bus_called("rs232"), start);
    for (const recording::Record& record : all.records) {
      player.extend({record});
      settle(player, start);
      if (!is_slow) REQUIRE(player.trace().records.size() <= 1);
    }
    CHECK(player.position() == (is_slow ? 0 : 5000));
    CHECK(player.trace().records.size() == (is_slow ? 5000 : 0));
    settle(player, start + 1h);
    CHECK(player.trace().records.size() <= 1);
    CHECK(agree(player.device(), inspect::device_after(all)));
  }
}

TEST_CASE("what is interposed is seen wherever one looks, until one follows") {
  const recording::Trace all = fills(100);
  Player player({}, recording::Trail::grows);
  player.extend({all.records.begin(), all.records.end()});
  advance_to_end(player);
  player.seek(50);
  const auto zoom = bytes_of({{Opcode::zoom, 0, {2}, {}}});
  player.interpose(zoom);
  for (const std::uint64_t place : {20U, 70U}) {
    player.seek(place);
    device::Device wanted = inspect::device_after(all, place);
    CHECK(player.device().registers.zoom == 2);
    CHECK(player.device().images == wanted.images);
  }
  CHECK(player.interposed() == zoom);
  player.follow();
  CHECK(player.device().registers.zoom == 0);
  CHECK(player.interposed().empty());
}

TEST_CASE("what is interposed takes its own time and not that of all before it") {
  const recording::Trace trace = fills(10);
  Player player(trace, recording::Trail::ends);
  play_out(player);
  const auto pan = bytes_of({{Opcode::pan, 0, {7, 9}, {}}});
  const auto processor_time = [](const auto& task) {
    const std::clock_t begin = std::clock();
    task();
    return std::clock() - begin;
  };
  // Each seek copies a device of 1.6 MB.
  const std::clock_t seeks = processor_time([&] {
    for (std::uint64_t i = 0; i < 200; ++i) player.seek(i % 2);
  });
  const std::clock_t interposed = processor_time([&] {
    for (int i = 0; i < 4000; ++i) player.interpose(pan);
  });
  CHECK(interposed < 2 * seeks);
  CHECK(player.device().registers.pan_x == 7);
  CHECK(player.interposed().size() == 4000 * pan.size());
}

TEST_CASE("at the pace of a bus a command is seen when that has brought it") {
  // A frame of some 25 bytes at 1,920 a second.
  const recording::Trace trace = fills(200);
  const auto frame = std::get<recording::Data>(trace.records[0]).bytes.size();
  Player player(trace, recording::Trail::ends);
  play_out(player);
  CHECK(player.position() == 0);
  player.play(bus_called("rs232"), start);
  player.advance(start);
  CHECK(player.position() == 0);
  player.advance(start + 1s);
  const double wanted = 1 / (static_cast<double>(frame) / 1920 + 36e-6);
  CHECK(static_cast<double>(player.position()) == Approx(wanted).margin(1.5));
  player.pause();
  const std::uint64_t there = player.position();
  player.advance(start + 2s);
  CHECK(player.position() == there);
  player.play(bus_called("fast"), start + 3s);
  for (int i = 0; i < 200; ++i) player.advance(start + 4s);
  CHECK(player.position() == 200);
}

TEST_CASE("a pace that waited for the stream does not run to make up for it") {
  const recording::Trace all = fills(200);
  Player player({}, recording::Trail::grows);
  player.play(bus_called("rs232"), start);
  player.extend({all.records.begin(), all.records.begin() + 10});
  player.advance(start + 100s); // all ten are due
  CHECK(player.position() == 10);
  player.extend({all.records.begin() + 10, all.records.end()});
  player.advance(start + 100s + 10ms);
  CHECK(player.position() <= 12);
}
