#include <halftone/core/error.h>

#include <catch2/catch.hpp>

#include <string>

using halftone::core::InputError;

TEST_CASE("an input error reads file, line, column, problem and advice in one line") {
  const InputError error({"a.toml", 12, 7}, "unknown key \"raduis\" in sphere", "did you mean \"radius\"?");
  CHECK(std::string(error.what()) ==
        "a.toml:12:7: unknown key \"raduis\" in sphere; did you mean \"radius\"?");
  CHECK(std::string(InputError({"a.toml", 0, 0}, "is a folder").what()) == "a.toml: is a folder");
}
