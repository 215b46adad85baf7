// convert: scenes in other formats.

#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"
#include "support/skip.h"

#include <halftone/png/compare.h>
#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using halftone::test::contents;
using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;
namespace fs = std::filesystem;
namespace png = halftone::png;

namespace {

std::vector<fs::path> scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(HALFTONE_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  return files;
}

Outcome convert(const std::string& in, const std::string& out) { return run_halftone({"convert", in, out}); }

bool has_povray() { return std::system("povray --version >/dev/null 2>&1") == 0; }

/// Flat, round and mirroring things in the light of two lamps, without glass: where POV-Ray's picture must be
/// ours.
constexpr const char* plain_scene = R"(format = 1
[image]
width = 96
height = 64
exposure = 1.25
[camera]
eye = [4, -7, 4]
target = [0.3, 0, 0.8]
fov = 35
[background]
color = [0.3, 0.4, 0.6]
[ambient]
color = [0.15, 0.2, 0.1]
[[light]]
position = [-4, -5, 8]
color = [0.6, 0.5, 0.4]
[[light]]
position = [6, -2, 5]
color = [0.2, 0.3, 0.3]
[material.floor]
diffuse = [0.8, 0.7, 0.6]
checker = { color = [0.2, 0.3, 0.4], size = 0.8, axes = "yx" }
[material.wall]
diffuse = [0.7, 0.5, 0.6]
checker = { color = [0.2, 0.2, 0.6], size = 0.7, axes = "xz" }
[material.shiny]
diffuse = [0.6, 0.2, 0.2]
specular = [0.6, 0.6, 0.6]
shininess = 25
[material.mirror]
diffuse = [0.1, 0.1, 0.1]
mirror = [0.8, 0.7, 0.6]
[[object]]
shape = "polygon"
material = "floor"
vertices = [[-6, -6, 0], [6, -6, 0], [6, 6, 0], [-6, 6, 0]]
[[object]]
shape = "box"
material = "wall"
min = [-5, 3.05, -0.03]
max = [5, 3.5, 2.55]
[[object]]
shape = "sphere"
material = "mirror"
center = [1.3, 0.8, 1.0]
radius = 0.9
[[object]]
shape = "prism"
material = "shiny"
base = [-1.2, 0, 0.2]
top = [-1, 0.3, 1.7]
radius = 0.8
sides = 5
[[object]]
shape = "cone"
material = "shiny"
base = [0.4, -1.8, 0.1]
apex = [0.5, -1.8, 1.2]
radius = 0.5
[[object]]
shape = "frustum"
material = "shiny"
base = [2.4, -1.2, 0.1]
top = [2.4, -1.3, 0.9]
base_radius = 0.3
top_radius = 0.5
)";

} // namespace

TEST_CASE("every scene that comes with the program converts to POV-Ray and to TOML") {
  const Scratch scratch;
  REQUIRE(scenes().size() > 60);
  for (const fs::path& scene : scenes()) {
    INFO(scene);
    const Outcome pov = convert(scene, scratch / "s.pov"), toml = convert(scene, scratch / "s.toml");
    INFO(pov.err << toml.err);
    CHECK(pov.exit_code == 0);
    CHECK((pov.out + pov.err).empty());
    const std::string text = contents(scratch / "s.pov");
    CHECK(text.find("camera {") != std::string::npos);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf") == std::string::npos);

    CHECK(toml.exit_code == 0);
    CHECK(convert(scratch / "s.toml", scratch / "again.toml").exit_code == 0);
    CHECK(contents(scratch / "again.toml") == contents(scratch / "s.toml"));
    CHECK(convert(scratch / "s.toml", scratch / "again.pov").exit_code == 0);
    CHECK(contents(scratch / "again.pov") == text);
  }
}

TEST_CASE("a scene that went through TOML gives the same picture, bit for bit") {
  const Scratch scratch;
  const std::vector<std::string> texts{
      small_scene(), small_scene(24, 16, "linear"), plain_scene,
      contents(HALFTONE_SOURCE_DIR "/scenes/features/placement.toml"),
      "format = 1\ntitle = \"a \\\"b\\\" \\\\ \\n c\"\n[camera]\neye = [1e-3, -7, 1e1]\ntarget = [0, 0.1, "
      "0]\n"
      "[image]\nwidth = 8\nheight = 8\n[material.\"x.y \\\"z\\\"\"]\nior = 1.5\n"
      "[[object]]\nshape = \"sphere\"\nmaterial = \"x.y \\\"z\\\"\"\ncenter = [0.1, 0.2, 0.3]\nradius = 1\n"};
  for (const std::string& text : texts) {
    scratch.write("a.toml", text);
    const Outcome outcome = convert(scratch / "a.toml", scratch / "b.toml");
    INFO(outcome.err << contents(scratch / "b.toml"));
    REQUIRE(outcome.exit_code == 0);
    for (const char* name : {"a", "b"})
      REQUIRE(run_halftone({"render", std::string(name) + ".toml", "--float", std::string(name) + ".pfm"},
                           {.folder = scratch.path()})
                  .exit_code == 0);
    CHECK(contents(scratch / "a.pfm") == contents(scratch / "b.pfm"));
    CHECK(contents(scratch / "a.png") == contents(scratch / "b.png"));
  }
}

TEST_CASE("convert takes the format from the name's ending, and knows no other") {
  const Scratch scratch;
  const std::string scene = scratch.write("s.toml", small_scene());
  for (const char* name : {"s.png", "s", "s.POV.gz"}) {
    const Outcome outcome = convert(scene, scratch / name);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find(".pov or .toml") != std::string::npos);
  }
  CHECK(convert(scene, scene).exit_code == 2);
  CHECK(run_halftone({"convert", scene}).exit_code == 2);
  CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
}

TEST_CASE("convert of what is wrong, or to where nothing can be written, leaves no file") {
  const Scratch scratch;
  const std::string bad = scratch.write("bad.toml", "format = 1\nbogus = 2\n");
  const std::string good = scratch.write("good.toml", small_scene());
  const Outcome outcome = convert(bad, scratch / "bad.pov");
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.starts_with("halftone: " + bad + ":2:1: "));
  CHECK(convert(scratch / "missing.toml", scratch / "bad.pov").exit_code == 3);
  CHECK(convert(good, scratch / "nowhere/s.pov").exit_code == 4);
  CHECK(scratch.names() == std::vector<std::string>{"bad.toml", "good.toml"});
}

TEST_CASE("POV-Ray draws the same picture where it has the same model of light") {
  if (!has_povray()) {
    halftone::test::skip_anywhere("POV-Ray is not installed (Debian: povray)");
    return;
  }
  for (const std::string transfer : {"srgb", "linear"}) {
    const Scratch scratch;
    std::string text = plain_scene;
    text.insert(text.find("exposure"), "transfer = \"" + transfer + "\"\n");
    scratch.write("s.toml", text);
    REQUIRE(convert(scratch / "s.toml", scratch / "s.pov").exit_code == 0);
    REQUIRE(run_halftone({"render", "s.toml"}, {.folder = scratch.path()}).exit_code == 0);
    const std::string gamma = transfer == "srgb" ? "srgb" : "1.0";
    const std::string command =
        "cd '" + scratch.path().string() +
        "' && povray +Is.pov +Opov.png +FN8 +W96 +H64 -D +AM1 +A0.0 +R9 -J File_Gamma=" + gamma +
        " >log 2>&1";
    const int status = std::system(command.c_str());
    INFO(contents(scratch / "log"));
    REQUIRE(status == 0);
    const png::Difference difference =
        png::compare(png::read(scratch / "s.png"), png::read(scratch / "pov.png"));
    CHECK(difference.rmse < 0.7);
    CHECK(difference.share_over_4 < 0.01);
  }
}
