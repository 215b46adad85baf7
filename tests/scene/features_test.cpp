// The scenes that come with the program are valid, and between them the small ones show every key.

#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace scene = halftone::scene;

namespace {

std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

const std::filesystem::path scenes = HALFTONE_SOURCE_DIR "/scenes";

} // namespace

TEST_CASE("the scenes of the house are valid") {
  const auto files = scenes_in(scenes);
  CHECK(files.size() >= 10);
  for (const auto& file : files) {
    INFO(file);
    CHECK_NOTHROW(scene::read_scene(file));
  }
}

TEST_CASE("the scenes of single features are valid, small, and say what they show") {
  const auto files = scenes_in(scenes / "features");
  CHECK(files.size() >= 30);
  for (const auto& file : files) {
    INFO(file);
    scene::Scene s;
    REQUIRE_NOTHROW(s = scene::read_scene(file));
    CHECK(s.image.width <= 160);
    CHECK(s.image.height <= 120);
    CHECK(s.title == file.stem().string());
    CHECK(contents(file).substr(0, 2) == "# ");
  }
}

TEST_CASE("every key and word of the format is used by a scene of single features") {
  std::string all;
  for (const auto& file : scenes_in(scenes / "features")) all += '\n' + contents(file);
  for (const std::string key :
       {"format",   "title",     "width",  "height",      "exposure",   "transfer",  "eye",     "target",
        "up",       "fov",       "depth",  "cutoff",      "facets",     "position",  "color",   "diffuse",
        "specular", "shininess", "mirror", "ior",         "absorption", "opaque",    "checker", "shape",
        "name",     "material",  "trace",  "scale",       "rotate",     "translate", "center",  "radius",
        "base",     "top",       "apex",   "base_radius", "top_radius", "min",       "max",     "sides",
        "turn",     "vertices",  "faces"}) {
    INFO(key);
    CHECK(all.find('\n' + key + " = ") != std::string::npos);
  }
  for (const std::string word :
       {"\ntransfer = \"srgb\"", "\ntransfer = \"linear\"", "\ntrace = \"auto\"", "\ntrace = \"always\"",
        "\ntrace = \"never\"", "\"sphere\"", "\"cylinder\"", "\"cone\"", "\"frustum\"", "\"box\"",
        "\"prism\"", "\"polyhedron\"", "\"polygon\"", "size = ", "axes = \"xy\"", "axes = \"yz\"",
        "axes = \"zx\"", "[background]", "[ambient]"}) {
    INFO(word);
    CHECK(all.find(word) != std::string::npos);
  }
}
