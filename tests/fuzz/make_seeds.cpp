// fuzz_seeds FOLDER: writes the seeds of fuzz_text and fuzz_trace, from the tests' random streams and
// recordings.

#include "../recording/random_trace.h"

#include <halftone/protocol/text.h>
#include <halftone/recording/text.h>
#include <halftone/recording/write.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

using namespace halftone;

namespace {

constexpr int files = 16;
constexpr std::size_t largest = 1500; // small ones are mutated faster

/// Calls make(random) until there are enough results of a good size.
template<typename Make>
void write(const std::filesystem::path& folder, Make make) {
  std::filesystem::create_directories(folder);
  test::Random random(1);
  for (int file = 0; file < files;) {
    const auto bytes = make(random);
    if (bytes.empty() || bytes.size() > largest) continue;
    std::ofstream stream(folder / ("seed-" + std::to_string(100 + file++)), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "Usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  write(folder / "text", [](test::Random& random) {
    if (random() % 2 == 0) return recording::disassemble(test::random_trace(random));
    return protocol::disassemble(test::random_stream(random, protocol::Direction::to_device));
  });
  write(folder / "trace", [](test::Random& random) { return encode(test::random_trace(random)); });
  return 0;
}
