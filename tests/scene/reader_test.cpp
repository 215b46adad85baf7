#include "support/scratch.h"
#include "support/skip.h"

#include <halftone/core/error.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>

using halftone::core::Color;
using halftone::core::InputError;
using halftone::core::Vec3;
namespace scene = halftone::scene;

namespace {

const std::string least = "format = 1\n[camera]\neye = [4, -6, 3]\ntarget = [0, 0, 1]\n";

scene::Scene read(const std::string& text) { return scene::read_toml(text, "test.toml"); }

/// The object of a scene whose only object has these lines.
scene::Object object_of(const std::string& lines) {
  return read(least + "[material.glass]\nior = 1.5\n[[object]]\n" + lines).objects.at(0);
}

/// The message with which the text is refused.
std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "was accepted";
}

std::string refusal_of_file(const std::filesystem::path& file) {
  try {
    scene::read_scene(file);
  } catch (const InputError& error) {
    CHECK(error.place.line == 0);
    return error.what();
  }
  return "was accepted";
}

} // namespace

TEST_CASE("a scene needs a format and a camera, and all else has the defaults that the format states") {
  const scene::Scene s = read(least);
  CHECK(s.title.empty());
  CHECK(s.image.width == 512);
  CHECK(s.image.height == 512);
  CHECK(s.image.exposure == 1);
  CHECK(s.image.transfer == scene::Transfer::srgb);
  CHECK(s.camera.eye == Vec3(4, -6, 3));
  CHECK(s.camera.target == Vec3(0, 0, 1));
  CHECK(s.camera.up == Vec3(0, 0, 1));
  CHECK(s.camera.fov == 40);
  CHECK(s.background == Color(0));
  CHECK(s.ambient == Color(0));
  CHECK(s.trace.depth == 5);
  CHECK(s.trace.cutoff == 0.01);
  CHECK(s.trace.facets == 24);
  CHECK(s.lights.empty());
  CHECK(s.objects.empty());
  REQUIRE(s.materials.size() == 1);
  CHECK(s.materials[0].name.empty());
  CHECK(s.materials[0].diffuse == Color(0.8));
  CHECK_FALSE(s.materials[0].glass);
}

TEST_CASE("coordinates nearer to 0 than 1e-60 are 0") {
  // The square of a light's distance from a floor that it is 1e-200 over was 0, its direction no number.
  CHECK(read("format = 1\n[camera]\neye = [1e-200, -9e-61, -1e-60]\ntarget = [0, 1, 0]\n").camera.eye ==
        Vec3(0, 0, -1e-60));
}

TEST_CASE("image, camera, surroundings, trace and lights are read") {
  const scene::Scene s = read(R"(
    format = 1
    title = "Größe"
    [image]
    width = 320
    height = 1
    exposure = 0.5
    transfer = "linear"
    [camera]
    eye = [1, 2.5, -3]
    target = [0, 0, 1e-3]
    up = [0, 1, 0]
    fov = 35.5
    [background]
    color = [0.1, 0.2, 30]
    [ambient]
    color = [1, 0, 0.25]
    [trace]
    depth = 1
    cutoff = 0
    facets = 3
    [[light]]
    position = [1, 2, 3]
    color = [4, 5, 6]
    [[light]]
    position = [7, 8, 9]
    color = [0, 0, 0]
  )");
  CHECK(s.title == "Größe");
  CHECK(s.image.width == 320);
  CHECK(s.image.height == 1);
  CHECK(s.image.exposure == 0.5);
  CHECK(s.image.transfer == scene::Transfer::linear);
  CHECK(s.camera.eye == Vec3(1, 2.5, -3));
  CHECK(s.camera.target == Vec3(0, 0, 1e-3));
  CHECK(s.camera.up == Vec3(0, 1, 0));
  CHECK(s.camera.fov == 35.5);
  CHECK(s.background == Color(0.1, 0.2, 30));
  CHECK(s.ambient == Color(1, 0, 0.25));
  CHECK(s.trace.depth == 1);
  CHECK(s.trace.cutoff == 0);
  CHECK(s.trace.facets == 3);
  REQUIRE(s.lights.size() == 2);
  CHECK(s.lights[0].position == Vec3(1, 2, 3));
  CHECK(s.lights[0].color == Color(4, 5, 6));
  CHECK(s.lights[1].position == Vec3(7, 8, 9));
}

TEST_CASE("materials are read in file order, after the default grey") {
  const scene::Scene s = read(least + R"(
    [material.zinc]
    diffuse = [0.1, 0.2, 0.3]
    specular = [2, 1, 0]
    shininess = 0
    mirror = [0.5, 1, 0]
    [material.amber]
    ior = 1.55
    absorption = [0, 1, 20]
    opaque = [1, 0.5, 0]
    [material."two words"]
    checker = { color = [0, 0.5, 1], size = 0.25, axes = "zx" }
    [material.plain]
    checker = { color = [0, 0, 0] }
    [material.tinted]
    ior = 1
    diffuse = [0.25, 0, 0]
  )");
  REQUIRE(s.materials.size() == 6);
  const scene::Material& zinc = s.materials[1];
  CHECK(zinc.name == "zinc");
  CHECK(zinc.diffuse == Color(0.1, 0.2, 0.3));
  CHECK(zinc.specular == Color(2, 1, 0));
  CHECK(zinc.shininess == 0);
  CHECK(zinc.mirror == Color(0.5, 1, 0));
  CHECK_FALSE(zinc.glass);
  CHECK_FALSE(zinc.checker);

  const scene::Material& amber = s.materials[2];
  CHECK(amber.name == "amber");
  REQUIRE(amber.glass);
  CHECK(amber.glass->ior == 1.55);
  CHECK(amber.glass->absorption == Color(0, 1, 20));
  CHECK(amber.opaque == Color(1, 0.5, 0));
  CHECK(amber.diffuse == Color(0)); // black where ior is given and diffuse is not
  CHECK(amber.specular == Color(0));
  CHECK(amber.shininess == 32);
  CHECK(amber.mirror == Color(0));

  CHECK(s.materials[3].name == "two words");
  REQUIRE(s.materials[3].checker);
  CHECK(s.materials[3].checker->color == Color(0, 0.5, 1));
  CHECK(s.materials[3].checker->size == 0.25);
  CHECK(s.materials[3].checker->axis_a == 2);
  CHECK(s.materials[3].checker->axis_b == 0);

  CHECK(s.materials[4].name == "plain");
  CHECK(s.materials[4].diffuse == Color(0.8));
  CHECK(s.materials[4].opaque == Color(0.7, 0.8, 0.85));
  REQUIRE(s.materials[4].checker);
  CHECK(s.materials[4].checker->size == 1);
  CHECK(s.materials[4].checker->axis_a == 0);
  CHECK(s.materials[4].checker->axis_b == 1);

  REQUIRE(s.materials[5].glass);
  CHECK(s.materials[5].glass->ior == 1);
  CHECK(s.materials[5].glass->absorption == Color(0));
  CHECK(s.materials[5].diffuse == Color(0.25, 0, 0));
}

TEST_CASE("absorption waits for the line that makes a material glass") {
  const scene::Scene s = read(least + "[material.later]\nabsorption = [1, 2, 3]\n");
  CHECK_FALSE(s.materials.at(1).glass);
}

TEST_CASE("an object has a name, a material, a rule of tracing and a placement") {
  const scene::Object bare = object_of("shape = \"sphere\"\ncenter = [0, 0, 1]\nradius = 2");
  CHECK(bare.shape_name == "sphere");
  CHECK(bare.name.empty());
  CHECK(bare.material == 0);
  CHECK(bare.trace == scene::TraceRule::automatic);
  CHECK(bare.placement.scale == 1);
  CHECK(bare.placement.rotate == Vec3(0));
  CHECK(bare.placement.translate == Vec3(0));

  const scene::Object full = object_of(R"(
    shape = "sphere"
    name = "lens"
    material = "glass"
    trace = "always"
    scale = 0.5
    rotate = [10, 20, 30]
    translate = [1, 2, 3]
    center = [0, 0, 1]
    radius = 2
  )");
  CHECK(full.name == "lens");
  CHECK(full.material == 1);
  CHECK(full.trace == scene::TraceRule::always);
  CHECK(full.placement.scale == 0.5);
  CHECK(full.placement.rotate == Vec3(10, 20, 30));
  CHECK(full.placement.translate == Vec3(1, 2, 3));

  const std::string never = "trace = \"never\"\n";
  CHECK(object_of(never + "shape = \"sphere\"\ncenter = [0, 0, 1]\nradius = 2").trace ==
        scene::TraceRule::never);
  CHECK(object_of(never + "shape = \"cone\"\nbase = [0, 0, 0]\napex = [0, 0, 1]\nradius = 2").trace ==
        scene::TraceRule::never);
  CHECK(object_of("trace = \"auto\"\nshape = \"box\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]").trace ==
        scene::TraceRule::automatic);
}

TEST_CASE("a sphere is read") {
  const auto sphere =
      std::get<scene::Sphere>(object_of("shape = \"sphere\"\ncenter = [1, 2, 3]\nradius = 4").shape);
  CHECK(sphere.center == Vec3(1, 2, 3));
  CHECK(sphere.radius == 4);
}

TEST_CASE("cylinder, cone and frustum are frusta") {
  const scene::Object cylinder =
      object_of("shape = \"cylinder\"\nbase = [1, 2, 3]\ntop = [4, 5, 6]\nradius = 7");
  CHECK(cylinder.shape_name == "cylinder");
  const auto equal = std::get<scene::Frustum>(cylinder.shape);
  CHECK(equal.base == Vec3(1, 2, 3));
  CHECK(equal.top == Vec3(4, 5, 6));
  CHECK(equal.base_radius == 7);
  CHECK(equal.top_radius == 7);

  const scene::Object cone = object_of("shape = \"cone\"\nbase = [1, 2, 3]\napex = [4, 5, 6]\nradius = 7");
  CHECK(cone.shape_name == "cone");
  const auto pointed = std::get<scene::Frustum>(cone.shape);
  CHECK(pointed.base == Vec3(1, 2, 3));
  CHECK(pointed.top == Vec3(4, 5, 6));
  CHECK(pointed.base_radius == 7);
  CHECK(pointed.top_radius == 0);

  const std::string lines = "shape = \"frustum\"\nbase = [1, 2, 3]\ntop = [4, 5, 6]\n";
  const auto frustum = std::get<scene::Frustum>(object_of(lines + "base_radius = 0\ntop_radius = 2").shape);
  CHECK(frustum.base_radius == 0);
  CHECK(frustum.top_radius == 2);
}

TEST_CASE("box and prism are read") {
  const auto box =
      std::get<scene::Box>(object_of("shape = \"box\"\nmin = [-1, 2, 3]\nmax = [4, 5, 6]").shape);
  CHECK(box.min == Vec3(-1, 2, 3));
  CHECK(box.max == Vec3(4, 5, 6));

  const std::string lines = "shape = \"prism\"\nbase = [1, 2, 3]\ntop = [4, 5, 6]\nradius = 7\nsides = 8\n";
  const auto prism = std::get<scene::Prism>(object_of(lines).shape);
  CHECK(prism.base == Vec3(1, 2, 3));
  CHECK(prism.top == Vec3(4, 5, 6));
  CHECK(prism.radius == 7);
  CHECK(prism.sides == 8);
  CHECK(prism.turn == 0);
  CHECK(std::get<scene::Prism>(object_of(lines + "turn = -22.5").shape).turn == -22.5);
}

TEST_CASE("polyhedron and polygon are read") {
  const std::string corners = "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
  const auto solid = std::get<scene::Polyhedron>(
      object_of("shape = \"polyhedron\"\n" + corners + "faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]")
          .shape);
  CHECK(solid.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(solid.faces == std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});

  const auto polygon = std::get<scene::Polygon>(
      object_of("shape = \"polygon\"\nvertices = [[0, 0, 0.5], [1, 0, 0.5], [1, 0, 0.5], [0, 1, 0.5]]")
          .shape);
  CHECK(polygon.vertices == std::vector<Vec3>{{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}}); // repeats count once
}

TEST_CASE("inline tables and dotted keys say the same as headers") {
  const scene::Scene s =
      read("format = 1\n"
           "camera.eye = [4, -6, 3]\n"
           "camera.target = [0, 0, 1]\n"
           "light = [{ position = [0, 0, 9], color = [1, 1, 1] }]\n"
           "material = { red = { diffuse = [1, 0, 0] } }\n"
           "object = [{ shape = 'sphere', center = [0, 0, 1], radius = 1, material = 'red' }]\n");
  CHECK(s.lights.size() == 1);
  REQUIRE(s.objects.size() == 1);
  CHECK(s.objects[0].material == 1);
}

TEST_CASE("a byte order mark and line ends of other systems change neither meaning nor places") {
  std::string dos = least;
  for (std::size_t at = 0; (at = dos.find('\n', at)) != std::string::npos; at += 2) dos.insert(at, "\r");
  const std::string mark = "\xEF\xBB\xBF";
  CHECK(read(mark + dos).camera.eye == Vec3(4, -6, 3));
  CHECK(refusal(mark + "formt = 1\r\n").find("test.toml:1:1: missing key \"format\"") == 0);
  CHECK(refusal(mark + dos + "fox = 2\r\n").find("test.toml:5:1: unknown key \"fox\" in camera") == 0);
}

TEST_CASE("columns count characters, not bytes") {
  CHECK(refusal("format = 1\ntitle = { é = 1 }\n").find("test.toml:2:11: ") == 0);
  CHECK(refusal("format = 1\n\"größe\" = 1\n" + least.substr(11))
            .find("test.toml:2:1: unknown key \"größe\"") == 0);
  CHECK(refusal(least + "up = ['ßß', true, 1]\n").find("test.toml:5:7: ") == 0);
  CHECK(refusal(least + "up = [ # ßß\n 'ßß', true, 1]\n").find("test.toml:6:2: ") == 0);
}

TEST_CASE("an empty text and one of comments lack a format") {
  const std::string expected =
      "test.toml:1:1: missing key \"format\" in scene; add format = 1 as the first line";
  CHECK(refusal("") == expected);
  CHECK(refusal("\xEF\xBB\xBF") == expected);
  CHECK(refusal("# nothing here\n\n") == expected);
}

TEST_CASE("a key of a hundred thousand parts is refused before it is nested") {
  std::string key = "a";
  for (int i = 0; i < 100000; ++i) key += i % 2 == 0 ? ".a" : " . \"a\"";
  CHECK(refusal(key + " = 1").find("a dotted key of more than 64 parts") != std::string::npos);
  CHECK(refusal(least + "[" + key + "]").find("a dotted key of more than 64 parts") != std::string::npos);
  for (const std::string part : {"\"=\"", "'#['", "\"a,\"", "\"\\\"\""}) {
    std::string quoted = part;
    for (int i = 0; i < 100000; ++i) quoted += "." + part;
    INFO(part);
    CHECK(refusal("format = 1\n" + quoted + " = 1").find("2:") == 10);
    CHECK(refusal("format = 1\n" + quoted + " = 1").find("a dotted key of more than 64 parts") !=
          std::string::npos);
  }
}

TEST_CASE("dots in numbers, texts and comments are no key") {
  std::string sentences;
  for (int k = 0; k < 200; ++k) sentences += "see fig. a. ";
  std::string lines = "# 1." + std::string(1000, '.') + sentences + " 2\ntitle = \"" + sentences + "\"\n";
  lines += "object = [{ shape = \"polygon\", vertices = [";
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.0314159 * k;
    lines += "[" + std::to_string(std::cos(angle)) + ", " + std::to_string(std::sin(angle)) + ", 0.0],";
  }
  lines += "] }]\n";
  CHECK_NOTHROW(read("format = 1\n" + lines + least.substr(11)));
}

TEST_CASE("a decision about the camera is the same at every scale and near every limit") {
  const auto with = [](const std::string& eye, const std::string& target, const std::string& up) {
    return refusal("format = 1\n[camera]\neye = " + eye + "\ntarget = " + target + "\nup = " + up + "\n");
  };
  // 1e-12 of a radian off is a direction; what is lost in the eye's own rounding is none.
  CHECK(with("[0, 0, 1]", "[0, 0, 0]", "[1e-12, 0, 1]") == "was accepted");
  CHECK(with("[0, 0, 1e30]", "[0, 0, 0]", "[1e-42, 0, 1e-30]") == "was accepted");
  CHECK(with("[0, 0, 1]", "[0, 0, 0]", "[1e-17, 0, 1]").find("parallel") != std::string::npos);
  CHECK(with("[1e9, 1e9, 1e9]", "[1000000001, 1e9, 1e9]", "[1, 1e-9, 0]").find("parallel") !=
        std::string::npos);
  CHECK(with("[1e9, 1e9, 1e9]", "[1000000001, 1e9, 1e9]", "[1, 1e-3, 0]") == "was accepted");
  CHECK(with("[0.1, 0.2, 0.3]", "[0.1, 0.2, 0.30000000000000004]", "[1, 0, 0]").find("is at \"eye\"") !=
        std::string::npos);
}

TEST_CASE("files that are no scenes are refused, each for its reason") {
  const halftone::test::Scratch folder;
  CHECK(refusal_of_file(folder.path() / "none.toml") ==
        (folder.path() / "none.toml").string() + ": no such file; check the path");
  CHECK(refusal_of_file(folder.path()).find("is a folder, expected a scene file") != std::string::npos);
  std::filesystem::create_directories(folder.path() / "folder.toml");
  CHECK(refusal_of_file(folder.path() / "folder.toml").find("is a folder") != std::string::npos);
  for (const std::string extension : {"nff", "obj", "ply", "gltf", "GLB"})
    CHECK(refusal_of_file(folder.write("x." + extension, "")).find(" are not supported yet") !=
          std::string::npos);
  CHECK(
      refusal_of_file(folder.write("x.png", "")).find("expected a file of type .toml, found type \".png\"") !=
      std::string::npos);
  CHECK(refusal_of_file(folder.write("scene", least)).find("found type \"\"") != std::string::npos);
  CHECK(scene::read_scene(folder.write("x.TOML", least)).camera.fov == 40);
}

TEST_CASE("a file without permission to read is refused") {
  const halftone::test::Scratch folder;
  const auto file = folder.write("closed.toml", least);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (std::ifstream(file)) return halftone::test::skip_anywhere("this user may read any file");
  CHECK(refusal_of_file(file).find("cannot be read; check its permissions") != std::string::npos);
}
