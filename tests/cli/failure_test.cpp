// What cannot work is found before the work, and leaves nothing behind.

#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"
#include "support/skip.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

using halftone::test::contents;
using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;
namespace fs = std::filesystem;

namespace {

/// Rendering this would take hours, so that a test which renders before it looks does not end in time.
const std::vector<std::string> endless = {"--mode", "reference", "--samples", "1000"};

Outcome render(const Scratch& scratch, std::vector<std::string> options) {
  options.insert(options.begin(), {"render", "s.toml"});
  options.insert(options.end(), endless.begin(), endless.end());
  return run_halftone(options, {.folder = scratch.path()});
}

} // namespace

TEST_CASE("a scene that is wrong exits with 3, its place and advice, and without an output file") {
  const Scratch scratch;
  scratch.write("s.toml", "format = 1\n[camera]\neye = [0, -8, 3]\ntarget = [0, 0, 0]\n"
                          "[[object]]\nshape = \"sphere\"\ncenter = [0, 0, 0]\nraduis = 1\n");
  const Outcome outcome = render(scratch, {"--float", "s.pfm", "--screen", "screen.png"});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.starts_with("halftone: s.toml:8:1: "));
  CHECK(outcome.err.find("raduis") != std::string::npos);
  CHECK(outcome.err.find("did you mean \"radius\"?") != std::string::npos);
  CHECK(outcome.out.empty());
  CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
}

TEST_CASE("a scene that is not there, is a folder or is no text exits with 3") {
  const Scratch scratch;
  CHECK(render(scratch, {}).exit_code == 3);
  fs::create_directory(scratch / "s.toml");
  CHECK(render(scratch, {}).exit_code == 3);
  fs::remove(scratch / "s.toml");
  scratch.write("s.toml", std::string("\x89PNG\r\n\x1a\n\0\0", 10));
  const Outcome outcome = render(scratch, {});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 3);
  CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
}

TEST_CASE("an output that cannot be written exits with 4 before anything is rendered") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  scratch.write("file", "");
  fs::create_directory(scratch / "folder");
  const std::vector<std::string> before = scratch.names();
  for (const std::string place : {"missing/x.png", "folder", "folder/", "file/x.png", "/dev/null"})
    for (const std::string option : {"-o", "--screen", "--float"}) {
      const Outcome outcome = render(scratch, {option, place});
      INFO(option << " " << place << "\n" << outcome.err);
      CHECK(outcome.exit_code == 4);
      CHECK(outcome.err.starts_with("halftone: " + place + ": cannot be written: "));
      CHECK(scratch.names() == before);
    }
}

TEST_CASE("an output in a folder that may not be written exits with 4 before anything is rendered") {
  if (::geteuid() == 0) {
    halftone::test::skip_anywhere("root may write everywhere");
    return;
  }
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  fs::create_directory(scratch / "locked");
  fs::permissions(scratch / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome outcome = render(scratch, {"-o", "locked/x.png"});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 4);
  fs::permissions(scratch / "locked", fs::perms::owner_all);
}

TEST_CASE("an older picture survives a render that fails") {
  const Scratch scratch;
  scratch.write("s.toml", "format = 2\n");
  scratch.write("s.png", "older");
  CHECK(render(scratch, {}).exit_code == 3);
  CHECK(contents(scratch / "s.png") == "older");
}

TEST_CASE("an answer that cannot be printed exits with 4") {
  const Scratch scratch;
  const std::string scene = scratch.write("s.toml", small_scene());
  const Outcome outcome = run_halftone({"info", scene}, {.out_file = "/dev/full"});
  CHECK(outcome.exit_code == 4);
  CHECK(outcome.err == "halftone: standard output cannot be written\n");
}
