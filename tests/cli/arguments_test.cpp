#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text = "halftone";
  for (const std::string& word : words) text += " " + word;
  return text;
}

} // namespace

TEST_CASE("bad arguments exit with 2, one line on stderr, nothing on stdout and no file") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const std::vector<std::vector<std::string>> bad = {
      {},
      {"paint"},
      {"--bogus"},
      {"render"},
      {"render", "s.toml", "t.toml"},
      {"render", "s.toml", "--mode", "global"},
      {"render", "s.toml", "--samples", "0"},
      {"render", "s.toml", "--samples", "-1"},
      {"render", "s.toml", "--samples", "2.5"},
      {"render", "s.toml", "--samples", "1001"},
      {"render", "s.toml", "--samples"},
      {"render", "s.toml", "--lines", "0"},
      {"render", "s.toml", "--lines", "1001"},
      {"render", "s.toml", "--lines", "two"},
      {"render", "s.toml", "--show", "everything"},
      {"render", "s.toml", "--threads", "0"},
      {"render", "s.toml", "--threads", "many"},
      {"render", "s.toml", "--simd", "sse"},
      {"render", "s.toml", "--timeout", "0"},
      {"render", "s.toml", "--timeout", "nan"},
      {"render", "s.toml", "--timeout", "1e300"},
      {"render", "s.toml", "--device", "nonsense"},
      {"render", "s.toml", "--device", "tcp:host:port"},
      {"render", "s.toml", "-o", "x.png", "--screen", "x.png"},
      {"render", "s.toml", "-o", "x.png", "--float", "./x.png"},
      {"render", "s.toml", "-o", "s.toml"},
      {"compare", "a.png"},
      {"compare", "a.png", "b.png", "--max-rmse", "-1"},
      {"compare", "a.png", "b.png", "--max-rmse", "nan"},
      {"compare", "a.png", "b.png", "--max-diff", "some"},
      {"check"},
      {"info"},
      {"info", "s.toml", "t.toml"},
  };
  for (const std::vector<std::string>& arguments : bad) {
    const Outcome outcome = run_halftone(arguments, {.folder = scratch.path()});
    INFO(joined(arguments) << "\nstderr: " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("halftone: "));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
  }
}

TEST_CASE("the help of the program and of every command goes to stdout and has an example") {
  for (const std::string command : {"", "render", "check", "compare", "info"}) {
    std::vector<std::string> arguments{"--help"};
    if (!command.empty()) arguments.insert(arguments.begin(), command);
    const Outcome outcome = run_halftone(arguments);
    INFO(joined(arguments) << "\n" << outcome.out);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(outcome.out.find("Usage: halftone") != std::string::npos);
    CHECK(outcome.out.find("Example:\n  halftone " + command) != std::string::npos);
  }
}

TEST_CASE("the help of the program names its commands and its exit codes") {
  const std::string help = run_halftone({"--help"}).out;
  for (const char* word : {"render", "check", "compare", "info", "Exit codes", "6 timeout"}) {
    INFO(word << " in\n" << help);
    CHECK(help.find(word) != std::string::npos);
  }
}

TEST_CASE("option --version prints one line with name and number") {
  const Outcome outcome = run_halftone({"--version"});
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, Catch::Matches("halftone [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}
