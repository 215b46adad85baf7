#include "random_stream.h"

namespace halftone::test {

namespace {

std::vector<std::uint8_t> random_bytes(Random& random, std::size_t most) {
  std::vector<std::uint8_t> bytes(random() % (most + 1));
  const bool uniform = random() % 2 == 0; // runs of equal bytes are abbreviated in text
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(uniform ? random() : random() % 2);
  return bytes;
}

protocol::Direction other(protocol::Direction direction) {
  return direction == protocol::Direction::to_host ? protocol::Direction::to_device
                                                   : protocol::Direction::to_host;
}

} // namespace

std::vector<std::uint8_t> random_stream(Random& random, protocol::Direction direction) {
  std::vector<std::uint8_t> stream;
  for (auto count = random() % 12; count > 0; --count) {
    switch (random() % 8) {
    case 0:
      append(stream, random_message(random, other(direction)).message);
      break;
    case 1: {
      const auto payload = random_bytes(random, 40);
      append(stream, protocol::Frame{static_cast<std::uint8_t>(random()),
                                     static_cast<std::uint32_t>(random()), payload});
      break;
    }
    case 2:
      stream.resize(stream.size() + random() % (random() % 16 == 0 ? 200'000 : 50));
      break;
    case 3: {
      const auto bytes = random_bytes(random, random() % 16 == 0 ? 3000 : 60);
      stream.insert(stream.end(), bytes.begin(), bytes.end());
      break;
    }
    default:
      append(stream, random_message(random, direction).message);
    }
  }
  return random() % 2 == 0 ? stream : damaged(random, stream);
}

} // namespace halftone::test
