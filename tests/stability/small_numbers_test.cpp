#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

// No tolerance hides in the engine: numbers with a negative exponent stand in one header of it.

namespace {

/// The text without comments and what is in quotes.
std::string code_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  static const std::regex not_code(R"(//[^\n]*|/\*[^]*?\*/|"(\\.|[^"\\\n])*")");
  return std::regex_replace(text, not_code, "");
}

/// The first number with a negative exponent, decimal or hexadecimal; empty where there is none. Halves and
/// quarters are not small.
std::string small_number_in(const std::string& code) {
  static const std::regex small(R"([0-9.]+[eE]-[0-9]+|0[xX][0-9a-fA-F.']+[pP]-([3-9]|[0-9]{2,}))");
  std::smatch match;
  return std::regex_search(code, match, small) ? match.str() : "";
}

} // namespace

TEST_CASE("numbers with a negative exponent stand in one header of the engine") {
  CHECK(small_number_in("x < 1e-9") == "1e-9");
  CHECK(small_number_in("x < 0x1.8p-20") == "0x1.8p-20");
  CHECK(small_number_in("x < 1.5E-12f") == "1.5E-12");
  CHECK(small_number_in("x - 1e9 - e-1 - 0x1.6p-1") == "");
  const std::filesystem::path engine = std::filesystem::path(HALFTONE_SOURCE_DIR) / "engine";
  int files = 0, with = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(engine)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    ++files;
    const std::string found = small_number_in(code_of(entry.path()));
    if (found.empty()) continue;
    INFO(entry.path().string() << " has " << found);
    CHECK(entry.path().filename() == "small_numbers.h");
    ++with;
  }
  CHECK(files > 100);
  CHECK(with == 1);
}
