// Whatever the text, reading returns a scene or throws InputError at a place inside it: scenes are damaged at
// random, in their bytes and in their values, and read.

#include <halftone/core/error.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

using halftone::core::InputError;
namespace scene = halftone::scene;

namespace {

std::vector<std::string> valid_texts() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(HALFTONE_SOURCE_DIR "/scenes/features"))
    files.push_back(entry.path());
  files.emplace_back(HALFTONE_SOURCE_DIR "/scenes/fig9a.toml");
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return texts;
}

class Damage {
public:
  explicit Damage(unsigned seed) : bits(seed) {}

  std::string of(std::string text) {
    for (std::size_t blows = 1 + below(4); blows > 0 && !text.empty(); --blows) strike(text);
    return text;
  }

  std::size_t below(std::size_t n) { return bits() % n; }

private:
  std::mt19937 bits;

  /// The place of a value's or key's first letter, and its length.
  std::pair<std::size_t, std::size_t> word(const std::string& text) {
    const std::string separators = " \n,=[]{}";
    const std::size_t start = std::min(text.find_first_not_of(separators, below(text.size())), text.size());
    return {start, std::min(text.find_first_of(separators, start), text.size()) - start};
  }

  void strike(std::string& text) {
    static const std::vector<std::string> values{"0",
                                                 "-1",
                                                 "1",
                                                 "1e300",
                                                 "-1e300",
                                                 "1e-300",
                                                 "1e60",
                                                 "nan",
                                                 "inf",
                                                 "9223372036854775807",
                                                 "0.5",
                                                 "\"\"",
                                                 "\"x\"",
                                                 "[]",
                                                 "{}",
                                                 "true",
                                                 "2",
                                                 "-0.0",
                                                 "3",
                                                 "[[1]]",
                                                 "1979-05-27T07:32:00",
                                                 "\xFF",
                                                 "'",
                                                 "\"",
                                                 "#",
                                                 "\0",
                                                 ".",
                                                 "=",
                                                 "\n",
                                                 "]",
                                                 "[[",
                                                 "\"never\"",
                                                 "1e40"};
    const std::size_t at = below(text.size());
    switch (below(7)) {
    case 0:
      text.resize(at);
      break;
    case 1:
      text[at] = static_cast<char>(bits());
      break;
    case 2:
      text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
      break;
    case 3:
      text.erase(at, 1 + below(12));
      break;
    case 4:
      text.insert(at, values[below(values.size())]);
      break;
    case 5: {
      const auto [start, length] = word(text);
      text.replace(start, length, values[below(values.size())]);
      break;
    }
    case 6: { // one value where another was
      const auto [from, from_length] = word(text);
      const std::string copy = text.substr(from, from_length);
      const auto [to, to_length] = word(text);
      text.replace(to, to_length, copy);
      break;
    }
    }
  }
};

} // namespace

TEST_CASE("a damaged scene is read or refused at a place inside it, and nothing else happens") {
  constexpr unsigned seed = 9;
  constexpr int trials = 6000;
  const std::vector<std::string> texts = valid_texts();
  Damage damage(seed);
  int accepted = 0, refused = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const std::string text = damage.of(texts[damage.below(texts.size())]);
    INFO("seed " << seed << ", trial " << trial << ", text:\n" << text);
    try {
      scene::read_toml(text, "damaged.toml");
      ++accepted;
    } catch (const InputError& error) {
      ++refused;
      const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
      const std::string message = error.what();
      if (error.place.line < 1 || error.place.line > lines + 1 || error.place.column < 1 ||
          message.find_first_of("\n\r") != std::string::npos || message.find("; ") == std::string::npos)
        FAIL("an unfit message: " << message);
    } catch (const std::exception& error) {
      FAIL("threw something else: " << error.what());
    }
  }
  CHECK(accepted > trials / 50);
  CHECK(refused > trials / 2);
}
