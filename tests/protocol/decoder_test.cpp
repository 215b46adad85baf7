#include "naive_codec.h"
#include "random_message.h"

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/decoder.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <ctime>

using namespace halftone::protocol;
using halftone::test::Bytes;
using halftone::test::describe;
using halftone::test::Random;

namespace {

Bytes random_stream(Random& random, int messages) {
  Bytes stream;
  for (int i = 0; i < messages; ++i) {
    append(stream, halftone::test::random_message(random, Direction::to_device).message);
    switch (random() % 8) {
    case 0:
      stream.insert(stream.end(), random() % 20, std::uint8_t{0});
      break;
    case 1: { // a whole frame that nobody knows
      const Bytes unknown =
          halftone::test::naive_frame(0x7E, static_cast<std::uint32_t>(random()), Bytes(random() % 30, 0x4D));
      stream.insert(stream.end(), unknown.begin(), unknown.end());
      break;
    }
    default:
      break;
    }
  }
  return stream;
}

std::vector<std::string> all_items(Decoder& decoder, std::span<const std::uint8_t> bytes) {
  std::vector<std::string> items;
  while (const auto item = decoder.next(bytes)) items.push_back(describe(*item));
  CHECK(bytes.empty());
  return items;
}

void drain_into(std::vector<std::string>& items, Decoder& decoder) {
  while (const auto item = decoder.drain()) items.push_back(describe(*item));
}

std::vector<std::string> decode(const Bytes& stream) {
  Decoder decoder(Direction::to_device);
  auto items = all_items(decoder, stream);
  drain_into(items, decoder);
  return items;
}

std::vector<std::string> decode_in_pieces(Random& random, const Bytes& stream, std::size_t largest_piece) {
  Decoder decoder(Direction::to_device);
  std::vector<std::string> items;
  std::span<const std::uint8_t> rest = stream;
  while (!rest.empty()) {
    const std::size_t size = std::min<std::size_t>(rest.size(), 1 + random() % largest_piece);
    const auto some = all_items(decoder, rest.first(size));
    items.insert(items.end(), some.begin(), some.end());
    rest = rest.subspan(size);
    if (random() % 8 == 0) decoder = Decoder(decoder); // a value, in mid-stream as well
  }
  drain_into(items, decoder);
  return items;
}

Bytes fill_command(std::uint32_t sequence) {
  Bytes bytes;
  append(bytes, Message{Opcode::fill, sequence, {1, 2, 3, 4, 5, 6, 7}, {}});
  return bytes;
}

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

} // namespace

TEST_CASE(
    "the decoder finds what the naive decoder finds, in damaged streams as well, however they are cut") {
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Random random(seed);
    const Bytes stream = halftone::test::damaged(random, random_stream(random, 6));
    INFO("seed " << seed << ", " << stream.size() << " bytes");
    const auto expected = halftone::test::naive_decode(stream, Direction::to_device);
    REQUIRE(decode(stream) == expected);
    REQUIRE(decode_in_pieces(random, stream, 1) == expected);
    REQUIRE(decode_in_pieces(random, stream, 64) == expected);
    REQUIRE(decode_in_pieces(random, stream, 5000) == expected);
  }
}

TEST_CASE("every byte of a stream is in one item, or is a zero between items") {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    const Bytes stream = halftone::test::damaged(random, random_stream(random, 6));
    Decoder decoder(Direction::to_device);
    std::uint64_t position = 0;
    const auto account_for = [&](const Item& item) {
      INFO("seed " << seed << ", " << describe(item));
      REQUIRE(item.offset >= position);
      for (; position < item.offset; ++position) REQUIRE(stream[position] == 0);
      position += item.size;
    };
    std::span<const std::uint8_t> bytes = stream;
    while (const auto item = decoder.next(bytes)) account_for(*item);
    while (const auto item = decoder.drain()) account_for(*item);
    for (; position < stream.size(); ++position) REQUIRE(stream[position] == 0);
    REQUIRE(position == stream.size());
  }
}

TEST_CASE("a command with any one bit wrong is skipped and reported, and its neighbours are not touched") {
  const Bytes before = fill_command(1), after = fill_command(3);
  for (std::size_t bit = 0; bit < 8 * fill_command(2).size(); ++bit) {
    Bytes wrong = fill_command(2);
    wrong[bit / 8] = static_cast<std::uint8_t>(wrong[bit / 8] ^ 1U << bit % 8);
    const auto items = decode(joined({before, wrong, after}));
    INFO("bit " << bit);
    REQUIRE(items.size() == 3);
    CHECK(items[0] == decode(before)[0]);
    CHECK(items[1] == describe({24, 24, Rejection{Fault::damaged, 1, 0}}));
    CHECK(items[2] ==
          halftone::test::naive_decode(joined({before, Bytes(24, 0), after}), Direction::to_device)[1]);
  }
}

TEST_CASE("after a command that was cut off anywhere the next one is found") {
  const Bytes whole = fill_command(2), after = fill_command(3);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const Bytes stream =
        joined({Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), after});
    const auto items = decode(stream);
    INFO("cut off after " << size << " bytes");
    REQUIRE(items.size() == 2);
    CHECK(items[0] == describe({0, size, Rejection{Fault::damaged, 0, 0}}));
    CHECK(items[1].find("fill 3") != std::string::npos);
  }
}

TEST_CASE("as many zeros as a frame can have bring any decoder to its feet without the end of the stream") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Bytes damage = halftone::test::damaged(random, random_stream(random, 4));
    const Bytes cut(damage.begin(),
                    damage.begin() + static_cast<std::ptrdiff_t>(random() % (damage.size() + 1)));
    Decoder decoder(Direction::to_device);
    const auto items = all_items(decoder, joined({cut, Bytes(frame_limit, 0), fill_command(77)}));
    INFO("seed " << seed);
    REQUIRE(!items.empty());
    REQUIRE(items.back().find("fill 77") != std::string::npos);
  }
}

TEST_CASE("a length beyond the limit is damage at once, and the decoder waits for nothing") {
  Bytes header{'M', '5', 0x11, 0, 0, 0, 1, 0x10, 0x01};
  Decoder decoder(Direction::to_device);
  const auto items = all_items(decoder, joined({header, fill_command(2)}));
  REQUIRE(items.size() == 2);
  CHECK(items[0] == describe({0, header.size(), Rejection{Fault::damaged, 0, 0}}));
}

TEST_CASE("a decoder that has been drained goes on") {
  Decoder decoder(Direction::to_device);
  const Bytes whole = fill_command(1);
  CHECK(all_items(decoder, std::span(whole).first(20)).empty());
  std::vector<std::string> items;
  drain_into(items, decoder);
  CHECK(items == std::vector{describe({0, 20, Rejection{Fault::damaged, 0, 0}})});
  items = all_items(decoder, whole);
  REQUIRE(items.size() == 1);
  CHECK(items[0].find("bytes 20 to 44: fill 1") == 0);
}

TEST_CASE("a decoder for one direction does not take messages of the other") {
  Bytes reply;
  append(reply, Message{Opcode::sum, 5, {42}, {}});
  CHECK(decode(reply) == std::vector{describe({0, 17, Rejection{Fault::unknown_opcode, 5, 0xA1}})});
}

TEST_CASE("a stream made of false headers costs a bounded time for each byte") {
  // The worst there is: every fourth byte begins a header, the eighth and ninth byte of which, 0F and the
  // next 'M', promise a payload of 3917 bytes, and all of it has to be checked.
  Bytes stream;
  while (stream.size() < 100'000) {
    const Bytes header{'M', '5', 0x11, 0x0F};
    stream.insert(stream.end(), header.begin(), header.end());
  }
  const auto processor_time = [](const auto& task) {
    const std::clock_t begin = std::clock();
    task();
    return std::clock() - begin;
  };
  std::vector<std::string> items;
  const auto decoded = processor_time([&] { items = decode(stream); });
  CHECK(items == std::vector{describe({0, stream.size(), Rejection{Fault::damaged, 0, 0}})});

  const std::size_t checked = 9 + 0x0F4D;
  std::uint32_t sums = 0;
  const auto summed = processor_time([&] {
    for (std::size_t i = 0; i + checked <= stream.size(); i += 4)
      sums ^= checksum(std::span(stream).subspan(i, checked));
  });
  INFO(decoded << " and " << summed << " of " << CLOCKS_PER_SEC << " s, " << sums);
  CHECK(decoded < 2 * summed);
}
