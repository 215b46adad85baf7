#include "random_stream.h"

#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace halftone;
using protocol::Direction;

TEST_CASE("every random stream, damaged or not, is assembled from its text form") {
  for (const Direction direction : {Direction::to_device, Direction::to_host}) {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
      test::Random random(seed);
      const auto stream = test::random_stream(random, direction);
      INFO("seed " << seed << ", " << stream.size() << " bytes");
      const std::string text = protocol::disassemble(stream, direction);
      REQUIRE(protocol::assemble(text) == stream);
    }
  }
}

TEST_CASE("a stream read in the wrong direction survives as well") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const auto stream = test::random_stream(random, Direction::to_host);
    INFO("seed " << seed);
    REQUIRE(protocol::assemble(protocol::disassemble(stream, Direction::to_device)) == stream);
  }
}

TEST_CASE("each command and reply, in a whole frame, is one line that names it") {
  test::Random random(1);
  for (const protocol::OpcodeEntry& entry : protocol::opcode_table) {
    for (int i = 0; i < 100; ++i) {
      const auto made = test::random_message(random, entry);
      std::vector<std::uint8_t> stream;
      append(stream, made.message);
      const std::string text = protocol::disassemble(stream, entry.direction);
      INFO(text);
      const std::string start = "#" + std::to_string(made.message.sequence) + " " + std::string(entry.name);
      CHECK(text.starts_with(start));
      CHECK(std::count(text.begin(), text.end(), '\n') == 1);
      REQUIRE(protocol::assemble(text) == stream);
    }
  }
}

TEST_CASE("the bytes of the lines are the stream without gaps") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const auto stream = test::random_stream(random, Direction::to_device);
    std::uint64_t end = 0;
    protocol::disassemble(stream, Direction::to_device, [&](const protocol::TextLine& line) {
      REQUIRE(line.offset == end);
      REQUIRE(line.size > 0);
      end += line.size;
    });
    REQUIRE(end == stream.size());
  }
}
