#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>

// No tolerance hides in the engine: small numbers stand in one header of it.

namespace {

/// The text without comments and what is in quotes.
std::string code_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  static const std::regex not_code(R"(//[^\n]*|/\*[^]*?\*/|"(\\.|[^"\\\n])*")");
  return std::regex_replace(text, not_code, "");
}

/// The first number with a negative exponent, decimal or hexadecimal, or what makes one: many noughts behind
/// the point, a division by a power, a power or a scaling with a negative exponent, the rounding of a type.
/// Empty where there is none. Halves and quarters are not small.
std::string small_number_in(const std::string& code) {
  static const std::regex small(
      R"([0-9.']+[eE]-[0-9]+|0[xX][0-9a-fA-F.']+[pP]-([0-9]{2,}|[3-9])|\b0?\.000[0-9]+)"
      R"(|/ *([0-9.']+[eE]\+?[0-9]+|0[xX][0-9a-fA-F.']+[pP]\+?([0-9]{2,}|[3-9])))"
      R"(|exp2\( *-|(scalbn|ldexp)\([^,()]*, *-[0-9]|epsilon\(\))");
  std::smatch match;
  return std::regex_search(code, match, small) ? match.str() : "";
}

/// Numbers that are no threshold of anything.
constexpr std::string_view excused[] = {
    "core/elementary.cpp",                     // the last digits of pi / 2
    "core/include/halftone/core/elementary.h", // and of ln 2
    "reference/reference.cpp",                 // random bits to [0, 1)
};

} // namespace

TEST_CASE("small numbers stand in one header of the engine") {
  for (const char* found : {"1e-9", "0x1.8p-20", "1.5E-12", "0.000001", "/ 1e9", "/ 0x1p40", "exp2(-",
                            "epsilon()", "ldexp(1.0, -4", "1'0e-9"})
    CHECK(small_number_in(std::string("x < y ") + found) == found);
  CHECK(small_number_in("x - 1e9 - e-1 - 0x1.6p-1 / 2 + 0.01 / 1000") == "");
  const std::filesystem::path engine = std::filesystem::path(HALFTONE_SOURCE_DIR) / "engine";
  int files = 0, with = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(engine)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    ++files;
    const std::string found = small_number_in(code_of(entry.path()));
    if (found.empty()) continue;
    ++with;
    const std::string place = entry.path().lexically_relative(engine).generic_string();
    INFO(place << " has " << found);
    const bool is_excused = std::find(std::begin(excused), std::end(excused), place) != std::end(excused);
    CHECK((is_excused || entry.path().filename() == "small_numbers.h"));
  }
  CHECK(files > 100);
  CHECK(with == 1 + static_cast<int>(std::size(excused)));
}
