// The keys of --json are those that docs/json.md promises, no fewer and no more.

#include "small_scene.h"
#include "support/json_keys.h"
#include "support/process.h"
#include "support/scratch.h"

#include <halftone/png/png.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using halftone::test::documented;
using halftone::test::keys_of;
using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;
using nlohmann::json;

TEST_CASE("render --json prints one object with the documented keys and nothing else") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const Outcome outcome =
      run_halftone({"render", "s.toml", "--mode", "full", "--threads", "2", "--json", "--stats"},
                   {.folder = scratch.path()});
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(keys_of(outcome.out) == documented("render"));

  const json answer = json::parse(outcome.out);
  CHECK(answer.at("width") == 24);
  CHECK(answer.at("height") == 16);
  CHECK(answer.at("mode") == "full");
  CHECK(answer.at("samples_per_side") == 4);
  CHECK(answer.at("lines") == 0);
  CHECK(answer.at("threads") == 2);
  CHECK(answer.at("simd") == "baseline");
  CHECK(answer.at("skipped") ==
        json{{"lights", 0}, {"objects", 0}, {"faces", 0}, {"casters", 0}, {"branches", 0}, {"samples", 0}});
  CHECK(answer.at("memory").at("bytes_an_object") > 100);
  CHECK(answer.at("memory").at("prepared_bytes") >= answer.at("memory").at("bytes_an_object"));
  CHECK(answer.at("rays").at("eye") > 0);
  CHECK(answer.at("rays").at("refracted") > 0);
  CHECK(answer.at("rays").at("reflected") > 0);
  CHECK(answer.at("rays").at("shadow") > 0);
  for (const char* time : {"prepare_seconds", "render_seconds", "device_seconds"}) {
    INFO(time);
    CHECK(answer.at(time) > 0);
    CHECK(answer.at(time) < 60);
  }
}

TEST_CASE("compare --json prints one object with the documented keys") {
  const Scratch scratch;
  halftone::png::write(scratch / "a.png", {2, 1, {1, 2, 3, 4, 5, 6}}, halftone::png::Encoding::srgb);
  const Outcome outcome = run_halftone({"compare", scratch / "a.png", scratch / "a.png", "--json"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(keys_of(outcome.out) == documented("compare"));
  CHECK(json::parse(outcome.out).at("rmse") == 0);
}

TEST_CASE("info --json prints one object with the documented keys") {
  const Scratch scratch;
  const Outcome outcome = run_halftone({"info", scratch.write("s.toml", small_scene()), "--json"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(keys_of(outcome.out) == documented("info"));
  const json answer = json::parse(outcome.out);
  CHECK(answer.at("objects").at(1).at("name") == "ball");
  CHECK(answer.at("objects").at(1).at("traced") == true);
  CHECK(answer.at("objects").at(3).at("reason") == "never");
  CHECK(answer.at("materials").at(answer.at("objects").at(1).at("material").get<std::size_t>()).at("kind") ==
        "glass");
  CHECK(answer.at("bounds") == json::parse("[[-6, -6, 0], [6, 6, 2]]"));
}

TEST_CASE("info --json of a scene without objects has no bounds") {
  const Scratch scratch;
  const std::string empty = "format = 1\n[camera]\neye = [0, -8, 3]\ntarget = [0, 0, 0]\n";
  const Outcome outcome = run_halftone({"info", scratch.write("s.toml", empty), "--json"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(json::parse(outcome.out).at("bounds").is_null());
  CHECK(json::parse(outcome.out).at("objects") == json::array());
}
