#include "random_message.h"
#include "table_receiver.h"

#include <halftone/protocol/decoder.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

using namespace halftone::protocol;
using halftone::test::Bytes;
using halftone::test::Random;
using halftone::test::TableReceiver;

namespace {

/// Commands, fill between them, damage, and an end anywhere.
Bytes random_stream(Random& random) {
  Bytes stream;
  for (auto messages = random() % 6; messages > 0; --messages) {
    stream.resize(stream.size() + random() % 3);
    append(stream, halftone::test::random_message(random, Direction::to_device).message);
  }
  stream = halftone::test::damaged(random, stream);
  if (random() % 4 == 0) stream.resize(random() % (stream.size() + 1));
  return stream;
}

/// Where table and decoder report differently; empty if nowhere.
std::string first_difference(std::vector<halftone::test::Transition>& table) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    TableReceiver receiver(table);
    Decoder decoder(Direction::to_device);
    for (int part = 0; part < 2; ++part) { // both go on after an end
      const Bytes stream = random_stream(random);
      const auto where = [&](std::size_t at) {
        return "seed " + std::to_string(seed) + ", part " + std::to_string(part) + ", byte " +
               std::to_string(at) + " of " + std::to_string(stream.size());
      };
      std::vector<std::string> found;
      for (std::size_t i = 0; i < stream.size(); ++i) {
        found.clear();
        std::span<const std::uint8_t> byte = std::span(stream).subspan(i, 1);
        while (const auto item = decoder.next(byte)) found.push_back(halftone::test::describe(*item));
        if (receiver.take(stream[i]) != found) return where(i);
      }
      found.clear();
      while (const auto item = decoder.drain()) found.push_back(halftone::test::describe(*item));
      if (receiver.end() != found) return where(stream.size());
    }
  }
  return {};
}

} // namespace

TEST_CASE("the decoder reports at every byte what the documented table of states reports") {
  auto table = halftone::test::documented_transitions();
  REQUIRE(table.size() == 15);
  CHECK(first_difference(table) == "");
  for (const auto& transition : table) {
    INFO("in state " << transition.state << " comes " << transition.event);
    CHECK(transition.taken > 50);
  }
}
