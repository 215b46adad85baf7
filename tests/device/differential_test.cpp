#include "../protocol/random_message.h"
#include "naive_device.h"

#include <halftone/device/device.h>

#include <catch2/catch.hpp>

using namespace halftone;
using test::Bytes;

namespace {

Bytes random_stream(test::Random& random) {
  Bytes stream;
  for (auto messages = 1 + random() % 16; messages > 0; --messages) {
    append(stream, test::random_message(random, protocol::Direction::to_device).message);
  }
  return random() % 4 == 0 ? test::damaged(random, stream) : stream;
}

void require_same_image(const device::Device& fast, const test::NaiveDevice& naive) {
  if (naive.holds(fast.image)) return;
  for (std::uint32_t y = 0; y < 512; ++y) {
    for (std::uint32_t x = 0; x < 512; ++x) {
      const std::size_t i = (y * 512 + x) * 3;
      const test::NaiveDevice::Pixel pixel{fast.image[i], fast.image[i + 1], fast.image[i + 2]};
      if (pixel == naive.pixel(x, y)) continue;
      FAIL("pixel (" << x << ", " << y << ") is "
                     << Catch::StringMaker<test::NaiveDevice::Pixel>::convert(pixel) << ", not "
                     << Catch::StringMaker<test::NaiveDevice::Pixel>::convert(naive.pixel(x, y)));
    }
  }
}

} // namespace

TEST_CASE("the device equals a naive device, pixel for pixel and reply for reply, on every stream") {
  std::size_t commands = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    test::Random random(seed);
    const Bytes stream = random_stream(random);
    std::span<const std::uint8_t> bytes = stream;
    protocol::Decoder decoder(protocol::Direction::to_device);
    device::Device fast;
    test::NaiveDevice naive;
    const auto both_execute = [&](const protocol::Item& item) {
      INFO("seed " << seed << ", command " << commands << ", " << test::describe(item));
      Bytes replies;
      fast.execute(item, replies);
      REQUIRE((replies == naive.execute(item)));
      ++commands;
    };
    while (const auto item = decoder.next(bytes)) both_execute(*item);
    while (const auto item = decoder.drain()) both_execute(*item);
    // What status tells of the registers:
    both_execute({0, 0, protocol::Message{protocol::Opcode::status, 0, {}, {}}});
    INFO("seed " << seed << ", at the end");
    require_same_image(fast, naive);
  }
  CHECK(commands > 10'000);
}

TEST_CASE("a device copied in mid-stream, with its decoder, goes on as the original does") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    const Bytes stream = random_stream(random);
    const auto run = [](protocol::Decoder& decoder, device::Device& device,
                        std::span<const std::uint8_t> bytes) {
      Bytes replies;
      while (const auto item = decoder.next(bytes)) device.execute(*item, replies);
      return replies;
    };
    const std::size_t middle = random() % (stream.size() + 1);
    protocol::Decoder decoder(protocol::Direction::to_device);
    device::Device device;
    run(decoder, device, std::span(stream).first(middle));
    protocol::Decoder copied_decoder = decoder;
    device::Device copy = device;
    const Bytes replies = run(decoder, device, std::span(stream).subspan(middle));
    INFO("seed " << seed << ", copied after " << middle << " bytes");
    REQUIRE((run(copied_decoder, copy, std::span(stream).subspan(middle)) == replies));
    REQUIRE((copy == device));
  }
}

TEST_CASE("bad input sets the error status and touches nothing else") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    device::Device device;
    Bytes replies;
    const Bytes stream = random_stream(random);
    std::span<const std::uint8_t> bytes = stream;
    protocol::Decoder decoder(protocol::Direction::to_device);
    while (const auto item = decoder.next(bytes)) device.execute(*item, replies);

    device::Device after = device;
    replies.clear();
    const auto fault =
        static_cast<protocol::Fault>(test::between(random, 1, protocol::fault_table.size() - 1));
    after.execute({0, 5, protocol::Rejection{fault, 99, 0x55}}, replies);
    INFO("seed " << seed);
    REQUIRE(replies.empty());
    REQUIRE(after.registers.errors == device.registers.errors + 1);
    if (device.registers.errors == 0) {
      REQUIRE(after.registers.error == fault);
      REQUIRE(after.registers.error_sequence == 99);
    } else {
      REQUIRE(after.registers.error == device.registers.error);
    }
    after.registers.error = device.registers.error;
    after.registers.error_sequence = device.registers.error_sequence;
    after.registers.errors = device.registers.errors;
    after.registers.skipped = device.registers.skipped;
    REQUIRE((after == device));
  }
}
