// Every file in malformed/ breaks one rule of the format and says in its first line what must come of it:
//   # expect LINE:COLUMN PART OF THE PROBLEM | PART OF THE ADVICE

#include <halftone/core/error.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using halftone::core::InputError;
namespace scene = halftone::scene;

namespace {

struct Expectation {
  int line = 0;
  int column = 0;
  std::string problem;
  std::string advice;
};

Expectation expectation_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string hash, word, rest;
  Expectation expected;
  char colon = 0;
  stream >> hash >> word >> expected.line >> colon >> expected.column >> std::ws;
  std::getline(stream, rest);
  if (hash.rfind("\xEF\xBB\xBF", 0) == 0) hash.erase(0, 3);  // some files have a byte order mark,
  if (!rest.empty() && rest.back() == '\r') rest.pop_back(); // some the line ends of DOS
  const std::size_t bar = rest.find(" | ");
  REQUIRE(hash == "#");
  REQUIRE(word == "expect");
  REQUIRE(bar != std::string::npos);
  expected.problem = rest.substr(0, bar);
  expected.advice = rest.substr(bar + 3);
  return expected;
}

std::vector<std::filesystem::path> malformed_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(HALFTONE_SOURCE_DIR "/tests/scene/malformed"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

TEST_CASE("every malformed scene is refused at its place, with what is wrong and what to do") {
  const auto files = malformed_files();
  REQUIRE(files.size() == 180);
  for (const auto& file : files) {
    INFO(file);
    const Expectation expected = expectation_in(file);
    try {
      scene::read_scene(file);
      FAIL_CHECK("was accepted");
    } catch (const InputError& error) {
      const std::string message = error.what();
      INFO(message);
      CHECK(error.place.file == file.string());
      CHECK(error.place.line == expected.line);
      CHECK(error.place.column == expected.column);
      const std::string place =
          file.string() + ":" + std::to_string(expected.line) + ":" + std::to_string(expected.column) + ": ";
      CHECK(message.rfind(place + expected.problem, 0) == 0);
      // The advice follows the problem and a semicolon.
      CHECK(message.find("; " + expected.advice, place.size() + expected.problem.size()) !=
            std::string::npos);
      CHECK(message.find('\n') == std::string::npos);
    }
  }
}
