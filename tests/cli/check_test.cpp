// check and info.

#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;

TEST_CASE("check is silent about good scenes") {
  const Scratch scratch;
  const std::string scene = scratch.write("s.toml", small_scene());
  const Outcome outcome = run_halftone({"check", scene, scene});
  CHECK(outcome.exit_code == 0);
  CHECK((outcome.out + outcome.err).empty());
}

TEST_CASE("check goes on after a bad scene and prints one line for each") {
  const Scratch scratch;
  scratch.write("good.toml", small_scene());
  scratch.write("bad.toml", "format = 1\nbogus = 2\n");
  scratch.write("worse.toml", "format = \n");
  const Outcome outcome = run_halftone({"check", "bad.toml", "good.toml", "worse.toml", "missing.toml"},
                                       {.folder = scratch.path()});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 3);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 3);
  CHECK(outcome.err.starts_with("halftone: bad.toml:2:1: "));
  CHECK(outcome.err.find("\nhalftone: worse.toml:1:") != std::string::npos);
  CHECK(outcome.err.find("\nhalftone: missing.toml: ") != std::string::npos);
  CHECK(scratch.names().size() == 3);
}

TEST_CASE("the scenes that come with the program are right") {
  std::vector<std::string> arguments{"check"};
  for (const auto& entry : std::filesystem::directory_iterator(HALFTONE_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml") arguments.push_back(entry.path());
  REQUIRE(arguments.size() > 10);
  const Outcome outcome = run_halftone(arguments);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("info tells which objects are traced and why") {
  const Scratch scratch;
  const Outcome outcome = run_halftone({"info", scratch.write("s.toml", small_scene())});
  INFO(outcome.out);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const char* line :
       {"title      small\n", "image      24 x 16, exposure 1, srgb\n",
        "bounds     (-6, -6, 0) to (6, 6, 2)\n", "lights     1\n", "objects    4, 2 of them traced\n",
        "polygon    floor        scanlines (flat)\n", "sphere     glass        traced (glass)  ball\n",
        "box        mirror       traced (mirror)\n", "cone       (default)    scanlines (never)\n"}) {
    INFO(line);
    CHECK(outcome.out.find(line) != std::string::npos);
  }
}

TEST_CASE("info of a scene that is wrong exits with 3 and prints nothing on stdout") {
  const Scratch scratch;
  const Outcome outcome = run_halftone({"info", scratch.write("s.toml", "format = 1\n")});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.empty());
}
