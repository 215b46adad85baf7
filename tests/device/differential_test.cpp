#include "../protocol/random_message.h"
#include "naive_device.h"
#include "support/effort.h"

#include <halftone/device/addressed.h>
#include <halftone/device/screen.h>
#include <halftone/device/snapshot.h>

#include <catch2/catch.hpp>

using namespace halftone;
using test::Bytes;

namespace {

constexpr std::uint64_t streams = 2000;

// A naive screen takes 10 ms: of most streams a few rows of it are compared, of every so many all.
constexpr std::uint64_t whole_screen_step = 16;
constexpr int rows_of_most = 8;

Bytes random_stream(test::Random& random) {
  Bytes stream;
  for (auto messages = 1 + random() % 16; messages > 0; --messages) {
    append(stream, test::random_message(random, protocol::Direction::to_device).message);
  }
  return random() % 4 == 0 ? test::damaged(random, stream) : stream;
}

std::string text(const test::NaiveDevice::Pixel& pixel) {
  return Catch::StringMaker<test::NaiveDevice::Pixel>::convert(pixel);
}

test::NaiveDevice::Pixel pixel(std::span<const std::uint8_t> image, std::uint32_t x, std::uint32_t y) {
  const std::size_t i = (y * 512 + x) * 3;
  return {image[i], image[i + 1], image[i + 2]};
}

void require_same_row(const device::Device& fast, const test::NaiveDevice& naive, std::uint32_t y) {
  std::array<std::uint8_t, std::size_t{512} * 3> shown;
  device::scan_out(fast, y, shown);
  for (std::uint32_t x = 0; x < 512; ++x) {
    for (const int buffer : {0, 1}) {
      const auto found = pixel(fast.images[static_cast<std::size_t>(buffer)], x, y);
      const auto wanted = naive.pixel(buffer, x, y);
      if (found != wanted)
        FAIL("pixel (" << x << ", " << y << ") of image " << buffer << " is " << text(found) << ", not "
                       << text(wanted));
    }
    const bool bit = (fast.overlay[y * 64 + x / 8] >> (7 - x % 8) & 1) != 0;
    if (bit != naive.overlay_bit(x, y)) FAIL("bit (" << x << ", " << y << ") of the overlay is " << bit);
    if (pixel(shown, x, 0) != naive.shown(x, y))
      FAIL("pixel (" << x << ", " << y << ") of the screen is " << text(pixel(shown, x, 0)) << ", not "
                     << text(naive.shown(x, y)));
  }
}

/// All of both images and of the overlay, and of the screen a few rows or all of them.
void require_same_memory(const device::Device& fast, const test::NaiveDevice& naive, test::Random& random,
                         bool is_whole) {
  const bool is_same =
      naive.holds(0, fast.images[0]) && naive.holds(1, fast.images[1]) && naive.holds_overlay(fast.overlay);
  if (is_same && !is_whole) {
    for (int i = 0; i < rows_of_most; ++i)
      require_same_row(fast, naive, static_cast<std::uint32_t>(random() % 512));
  } else {
    for (std::uint32_t y = 0; y < 512; ++y) require_same_row(fast, naive, y);
  }
  REQUIRE(is_same);
  REQUIRE(fast.clock.picoseconds == naive.picoseconds());
}

} // namespace

TEST_CASE("the device equals a naive device, pixel for pixel and reply for reply, on every stream") {
  std::size_t commands = 0;
  for (std::uint64_t seed = 0; seed < streams; seed += test::seed_step) {
    test::Random random(seed);
    const Bytes stream = random_stream(random);
    std::span<const std::uint8_t> bytes = stream;
    protocol::Decoder decoder(protocol::Direction::to_device);
    const device::Bus bus{"some", random() % 600'000'000, random() % 1'000'000'000};
    device::Device fast;
    fast.clock.bus = bus;
    test::NaiveDevice naive(bus.byte_picoseconds, bus.frame_picoseconds);
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
    require_same_memory(fast, naive, random, seed % whole_screen_step == 0);
  }
  CHECK(commands > 5 * streams / test::seed_step);
}

TEST_CASE("a device that follows a stream comes to the same state as one that answers") {
  for (std::uint64_t seed = 0; seed < streams; seed += test::seed_step) {
    test::Random random(seed);
    const Bytes stream = random_stream(random);
    std::span<const std::uint8_t> bytes = stream;
    protocol::Decoder decoder(protocol::Direction::to_device);
    device::Device answers, follows;
    answers.clock.bus = follows.clock.bus = {"some", random() % 600'000'000, random() % 1'000'000'000};
    Bytes replies;
    while (const auto item = decoder.next(bytes)) {
      answers.execute(*item, replies);
      follows.execute(*item);
    }
    INFO("seed " << seed);
    REQUIRE((follows == answers));
  }
}

TEST_CASE("a device copied in mid-stream, with its decoder, goes on as the original does") {
  for (std::uint64_t seed = 0; seed < streams; seed += test::seed_step) {
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
  for (std::uint64_t seed = 0; seed < streams; seed += test::seed_step) {
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
    after.clock = device.clock;
    REQUIRE((after == device));
  }
}

TEST_CASE("a snapshot restored in mid-stream goes on exactly, and nothing else is taken for one") {
  for (std::uint64_t seed = 0; seed < streams; seed += test::seed_step) {
    test::Random random(seed);
    const Bytes stream = random_stream(random), rest = random_stream(random);
    const auto run = [](device::Device& device, std::span<const std::uint8_t> bytes) {
      Bytes replies;
      protocol::Decoder decoder(protocol::Direction::to_device);
      while (const auto item = decoder.next(bytes)) device.execute(*item, replies);
      return replies;
    };
    device::Device device;
    run(device, stream);
    Bytes saved = device::save(device);
    std::optional<device::Device> restored = device::restore(saved);
    INFO("seed " << seed);
    REQUIRE(restored);
    REQUIRE((*restored == device));
    REQUIRE(device::state_checksum(*restored) == device::state_checksum(device));
    REQUIRE((run(*restored, rest) == run(device, rest)));
    REQUIRE((*restored == device));

    // Any other bytes are refused, or are the state of some device.
    saved[random() % 60] ^= static_cast<std::uint8_t>(1U << random() % 8);
    if (const auto other = device::restore(saved)) REQUIRE((device::save(*other) == saved));
    saved.pop_back();
    REQUIRE_FALSE(device::restore(saved));
  }
}

TEST_CASE("the addressed regions are what a command writes, all of it and nothing else") {
  using device::Plane;
  for (std::uint64_t seed = 0; seed < 600; seed += test::seed_step) {
    test::Random random(seed);
    device::Device device;
    Bytes replies;
    const Bytes stream = random_stream(random);
    std::span<const std::uint8_t> bytes = stream;
    protocol::Decoder decoder(protocol::Direction::to_device);
    while (const auto item = decoder.next(bytes)) device.execute(*item, replies);
    const auto command = test::random_message(random, protocol::Direction::to_device);
    const auto regions = device::addressed(device.registers, command.message);

    // Inverted where the command should write: it changes all of that, or leaves it by having the same value.
    device::Device marked = device;
    const auto for_each_pixel = [&](auto visit) {
      for (const device::Region& region : regions)
        for (std::uint32_t y = region.area.y; y < std::uint32_t{region.area.y} + region.area.height; ++y)
          for (std::uint32_t x = region.area.x; x < std::uint32_t{region.area.x} + region.area.width; ++x)
            visit(region.plane, x, y);
    };
    std::vector<bool> is_addressed[3]{std::vector<bool>(512 * 512), std::vector<bool>(512 * 512),
                                      std::vector<bool>(512 * 512)};
    for_each_pixel([&](Plane plane, std::uint32_t x, std::uint32_t y) {
      is_addressed[static_cast<std::size_t>(plane)][y * 512 + x] = true;
    });
    for (std::size_t p = 0; p < 512 * 512; ++p) {
      for (std::size_t buffer = 0; buffer < 2; ++buffer)
        for (std::size_t c = 0; c < 3; ++c) marked.images[buffer][p * 3 + c] ^= 0xFF;
    }
    for (std::uint8_t& byte : marked.overlay) byte ^= 0xFF;
    const device::Device before = device, marked_before = marked;
    const protocol::Item item{0, 0, command.message};
    device.execute(item, replies);
    marked.execute(item, replies);
    INFO("seed " << seed << ", " << test::describe(item));
    // A pixel that neither of two opposite memories changes was not written; with an open mask, one that was
    // written is the same in both (but for a copy, which brings each its own).
    const bool open = before.registers.write_mask == device::Pixel{255, 255, 255};
    const bool is_copy = command.message.opcode == protocol::Opcode::copy;
    std::size_t wrong = 0;
    for (std::size_t p = 0; p < 512 * 512; ++p) {
      for (std::size_t buffer = 0; buffer < 2; ++buffer) {
        for (std::size_t i = 3 * p; i < 3 * p + 3; ++i) {
          const bool changed = device.images[buffer][i] != before.images[buffer][i] ||
                               marked.images[buffer][i] != marked_before.images[buffer][i];
          if (changed && !is_addressed[buffer][p]) ++wrong;
          if (!changed && is_addressed[buffer][p] && open && !is_copy) ++wrong;
        }
      }
      const auto bit = [&](const device::Device& d) { return d.overlay[p / 8] >> (7 - p % 8) & 1; };
      const bool changed = bit(device) != bit(before) || bit(marked) != bit(marked_before);
      if (changed != is_addressed[2][p]) ++wrong;
    }
    REQUIRE(wrong == 0);
  }
}
