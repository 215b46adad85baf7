#include "suggestion.h"

#include <catch2/catch.hpp>

#include <string>

using halftone::scene::did_you_mean;
using halftone::scene::in_quotes;

TEST_CASE("a misspelt word finds the nearest known one") {
  const std::vector<std::string_view> known{"center", "radius", "rotate", "translate", "scale"};
  CHECK(did_you_mean("raduis", known, "") == "did you mean \"radius\"?");
  CHECK(did_you_mean("Center", known, "") == "did you mean \"center\"?");
  CHECK(did_you_mean("centre", known, "") == "did you mean \"center\"?");
  CHECK(did_you_mean("transalte", known, "") == "did you mean \"translate\"?");
  CHECK(did_you_mean("rotation", known, "") == "did you mean \"rotate\"?");
}

TEST_CASE("a word far from all known ones is not guessed at") {
  CHECK(did_you_mean("x", {"up"}, "otherwise") == "otherwise");
  CHECK(did_you_mean("base", {"name", "min", "max"}, "otherwise") == "otherwise");
  CHECK(did_you_mean("intensity", {"position", "color"}, "otherwise") == "otherwise");
  CHECK(did_you_mean(std::string(100000, 'a'), {"color"}, "otherwise") == "otherwise");
  CHECK(did_you_mean("color", {}, "otherwise") == "otherwise");
}

TEST_CASE("quoted words stay on one line, are cut between code points and show that they were cut") {
  CHECK(in_quotes("glass") == "\"glass\"");
  CHECK(in_quotes("a\nb\tc") == "\"a b c\"");
  CHECK(in_quotes(std::string(50, 'x')) == '"' + std::string(40, 'x') + "...\"");
  CHECK(in_quotes(std::string(39, 'x') + "\u00e9" + "y") == '"' + std::string(39, 'x') + "...\"");
}
