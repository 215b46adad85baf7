#include "support/effort.h"

#include <halftone/png/png.h>
#include <halftone/reference/reference.h>
#include <halftone/render/quantise.h>
#include <halftone/scene/read.h>
#include <halftone/scene/world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <string>

// The brute-force renderer with 16 x 16 samples a pixel against pictures of another program, on a lattice of
// pixels; on all of them with the hidden tag [long].

using namespace halftone;

namespace {

// Of the pixels that are compared.
constexpr int lattice = test::sanitized ? 29 : 7;

struct Error {
  double rmse = 0;
  int largest = 0;
  int largest_x = 0;
  int largest_y = 0;
};

Error compare(const scene::Scene& drawn, const std::string& golden, int every) {
  const png::Picture picture = png::read(HALFTONE_SOURCE_DIR "/tests/golden/" + golden + ".png");
  REQUIRE(picture.width == drawn.image.width);
  REQUIRE(picture.height == drawn.image.height);
  const scene::World world = scene::make_world(drawn);
  const reference::Reference reference(world);
  reference::Counts counts;
  Error error;
  double sum = 0;
  int channels = 0;
  for (int y = every / 2; y < picture.height; y += every)
    for (int x = every / 2; x < picture.width; x += every) {
      const core::Color color = reference.pixel(x, y, 16, reference::Sampling::stratified, counts);
      for (int channel = 0; channel < 3; ++channel, ++channels) {
        const int wanted = picture.rgb[3 * (static_cast<std::size_t>(y) * picture.width + x) + channel];
        const int difference = std::abs(render::quantise(color[channel], drawn.image) - wanted);
        sum += difference * difference;
        if (difference > error.largest) error = {0, difference, x, y};
      }
    }
  error.rmse = std::sqrt(sum / channels);
  return error;
}

void check(const std::string& name, int every) {
  const Error error =
      compare(scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml"), name, every);
  INFO(name << ": rmse " << error.rmse << ", largest " << error.largest << " at " << error.largest_x << ", "
            << error.largest_y);
  CHECK(error.rmse < 0.4);
  CHECK(error.largest <= 16);
  if (every == 1) WARN(name << ": rmse " << error.rmse << ", largest " << error.largest);
}

} // namespace

// One case a scene, so that they run side by side.
TEST_CASE("reference draws fig9a") { check("fig9a", lattice); }
TEST_CASE("reference draws fig9b") { check("fig9b", lattice); }
TEST_CASE("reference draws contact") { check("contact", lattice); }
TEST_CASE("reference draws nested") { check("nested", lattice); }
TEST_CASE("reference draws inside") { check("inside", lattice); }
TEST_CASE("reference draws mirrors") { check("mirrors", lattice); }
TEST_CASE("reference draws sliver") { check("sliver", lattice); }
TEST_CASE("reference draws cyclic") { check("cyclic", lattice); }
TEST_CASE("reference draws opaque") { check("opaque", lattice); }
TEST_CASE("reference draws round") { check("round", lattice); }

TEST_CASE("reference draws the scanline pictures from scenes made opaque and faceted") {
  for (const std::string name : {"fig9a", "fig9b", "mirrors"}) {
    const auto scanline =
        scene::scanline_scene(scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml"));
    // Fewer pixels than some 200 have no mean worth the name.
    const Error error = compare(scanline, "scanline/" + name, 28);
    INFO(name << ": rmse " << error.rmse << ", largest " << error.largest << " at " << error.largest_x << ", "
              << error.largest_y);
    CHECK(error.rmse < 0.4);
    CHECK(error.largest <= 16);
  }
}

TEST_CASE("reference draws every pixel of the ten scenes", "[.][long]") {
  for (const std::string name :
       {"fig9a", "fig9b", "contact", "nested", "inside", "mirrors", "sliver", "cyclic", "opaque", "round"})
    check(name, 1);
}
