// Progress, colour and signals.

#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"
#include "support/skip.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <string>
#include <vector>

using halftone::test::has_terminals;
using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;

namespace {

/// Its rows take milliseconds, all of them more than a second.
const std::vector<std::string> slow = {"render",    "s.toml", "--mode",  "reference",
                                       "--samples", "60",     "--float", "s.pfm"};

bool skip_without_terminals() {
  if (has_terminals()) return false;
  halftone::test::skip_anywhere("this machine has no pseudo-terminals");
  return true;
}

} // namespace

TEST_CASE("progress with the time left appears on a terminal, and a signal then leaves no file") {
  if (skip_without_terminals()) return;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Scratch scratch;
    scratch.write("s.toml", small_scene(16, 512));
    const Outcome outcome = run_halftone(
        slow, {.folder = scratch.path(), .terminal = true, .on_stderr = [&](const std::string& text) {
                 return text.find(" left") != std::string::npos ? signal : 0;
               }});
    INFO("signal " << signal << ", stderr: " << outcome.err);
    CHECK_THAT(outcome.err, Catch::Matches("\\rhalftone: row [0-9]+ of 512, ([0-9]+ (s|min|h) ?)+left\\s*"));
    CHECK(outcome.signal == signal);
    CHECK(outcome.out.empty());
    CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
  }
}

TEST_CASE("a quick render says nothing on a terminal") {
  if (skip_without_terminals()) return;
  const Scratch scratch;
  scratch.write("s.toml", small_scene(2, 2));
  const Outcome outcome = run_halftone({"render", "s.toml", "--mode", "full", "--samples", "1"},
                                       {.folder = scratch.path(), .terminal = true});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("a slow render says nothing where stderr is not a terminal") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene(4, 512));
  const Outcome outcome = run_halftone(slow, {.folder = scratch.path()});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("NO_COLOR keeps escape sequences away from a terminal") {
  if (skip_without_terminals()) return;
  const Scratch scratch;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"check", "missing.toml"}, {"--bogus"}, {"render", "s.toml"}}) {
    const Outcome outcome =
        run_halftone(arguments, {.folder = scratch.path(), .environment = {"NO_COLOR=1"}, .terminal = true});
    INFO(outcome.err);
    CHECK(outcome.exit_code != 0);
    CHECK(outcome.err.starts_with("halftone: "));
    CHECK(outcome.err.find('\033') == std::string::npos);
  }
}
