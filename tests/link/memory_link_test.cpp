#include <halftone/link/link.h>

#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace halftone;
using namespace std::chrono_literals;

TEST_CASE("the device in memory answers over its link, in pieces as small as one likes") {
  const auto link = link::open("mem:");
  std::vector<std::uint8_t> query, expected;
  append(query, protocol::Message{protocol::Opcode::checksum, 3, {0, 0, 1, 1}, {}});
  append(expected, protocol::Message{protocol::Opcode::sum, 3, {0xFF41D912}, {}}); // of three zeros
  for (const std::uint8_t byte : query) link->send({&byte, 1});
  std::vector<std::uint8_t> answer;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    std::uint8_t byte = 0;
    REQUIRE(link->receive({&byte, 1}, 1ms) == 1);
    answer.push_back(byte);
  }
  CHECK(answer == expected);
}

TEST_CASE("where nothing will come, the link in memory does not wait") {
  const auto link = link::open("mem:");
  std::uint8_t byte = 0;
  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_AS(link->receive({&byte, 1}, 10s), link::Timeout);
  CHECK(std::chrono::steady_clock::now() - start < 5s);
}

TEST_CASE("each link in memory has a device of its own") {
  const auto one = link::open("mem:"), other = link::open("mem:");
  std::vector<std::uint8_t> query;
  append(query, protocol::Message{protocol::Opcode::identify, 1, {}, {}});
  one->send(query);
  std::vector<std::uint8_t> buffer(100);
  CHECK_THROWS_AS(other->receive(buffer, 1ms), link::Timeout);
  CHECK(one->receive(buffer, 1ms) > 0);
}
