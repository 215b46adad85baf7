#include "number_table.h"

#include <halftone/core/mixed.h>

#include <catch2/catch.hpp>

#include <random>
#include <unordered_map>

using namespace halftone;

TEST_CASE("a table gives each key the number that it had first") {
  std::mt19937_64 random(1);
  scan::NumberTable table;
  std::unordered_map<std::uint64_t, int> expected;
  for (int i = 0; i < 20'000; ++i) { // grows nine times and more
    const std::uint64_t number = random() % 8'000;
    // Some with the same last bits, one of all noughts.
    const std::uint64_t key = number % 3 == 0 ? number << 40 : core::mixed(number);
    const int known = expected.try_emplace(key, i).first->second;
    REQUIRE(table.number_of(key, i) == known);
  }
  CHECK(expected.size() > 6'000);
}
