#include <halftone/png/png.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

// The paper's method with 8 virtual scanlines a row against pictures of another program, every pixel.

using namespace halftone;

namespace {

struct Drawn {
  render::Statistics statistics;
  double rmse = 0; ///< in 8-bit levels
  int largest = 0;
};

Drawn draw(const std::string& scene, const std::string& golden, render::Mode mode) {
  const png::Picture wanted = png::read(HALFTONE_SOURCE_DIR "/tests/golden/" + golden + ".png");
  const auto read = scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + scene + ".toml");
  REQUIRE(wanted.width == read.image.width);
  REQUIRE(wanted.height == read.image.height);
  Drawn drawn;
  double sum = 0;
  drawn.statistics = render::render(read, {.mode = mode, .lines = 8}, [&](const render::Row& row) {
    for (std::size_t i = 0; i < row.rgb.size(); ++i) {
      const int difference = std::abs(row.rgb[i] - wanted.rgb[row.y * row.rgb.size() + i]);
      sum += difference * difference;
      drawn.largest = std::max(drawn.largest, difference);
    }
  });
  drawn.rmse = std::sqrt(sum / static_cast<double>(wanted.rgb.size()));
  return drawn;
}

void check_local(const std::string& name) {
  const Drawn drawn = draw(name, name, render::Mode::local);
  INFO(name << ": rmse " << drawn.rmse << ", largest " << drawn.largest);
  CHECK(drawn.rmse < 1.0);
  CHECK(drawn.largest < 40); // the most that was measured is 31; one wrong sample of the 8 x 8 could be more
}

} // namespace

TEST_CASE("local draws fig9a") { check_local("fig9a"); }
TEST_CASE("local draws fig9b") { check_local("fig9b"); }
TEST_CASE("local draws contact") { check_local("contact"); }
TEST_CASE("local draws nested") { check_local("nested"); }
TEST_CASE("local draws inside") { check_local("inside"); }
TEST_CASE("local draws mirrors") { check_local("mirrors"); }
TEST_CASE("local draws sliver") { check_local("sliver"); }
TEST_CASE("local draws cyclic") { check_local("cyclic"); }
TEST_CASE("local draws round") { check_local("round"); }

TEST_CASE("local draws the scene of flat opaque things without a ray") {
  const Drawn drawn = draw("opaque", "opaque", render::Mode::local);
  INFO("rmse " << drawn.rmse << ", largest " << drawn.largest);
  CHECK(drawn.rmse < 1.0);
  CHECK(drawn.largest < 40);
  CHECK(drawn.statistics.rays.eye == 0);
  CHECK(drawn.statistics.rays.reflected == 0);
  CHECK(drawn.statistics.rays.refracted == 0);
  CHECK(drawn.statistics.rays.shadow == 0);
  CHECK(drawn.statistics.traced_pixels == 0);
}

TEST_CASE("scanline draws its three pictures without a ray") {
  for (const std::string name : {"fig9a", "fig9b", "mirrors"}) {
    const Drawn drawn = draw(name, "scanline/" + name, render::Mode::scanline);
    INFO(name << ": rmse " << drawn.rmse << ", largest " << drawn.largest);
    CHECK(drawn.rmse < 0.6);
    CHECK(drawn.largest < 40);
    CHECK(drawn.statistics.rays.eye == 0);
    CHECK(drawn.statistics.rays.shadow == 0);
    CHECK(drawn.statistics.traced_pixels == 0);
  }
}
