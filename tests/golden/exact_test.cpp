#include <halftone/png/png.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

// Default settings against pictures of another program, every pixel.

using namespace halftone;

namespace {

/// Under sanitizers only what is drawn quickly.
std::vector<std::string> scenes() {
#if HALFTONE_LATTICE < 10
  return {"fig9a", "fig9b", "contact", "nested", "inside", "mirrors", "sliver", "cyclic", "opaque", "round"};
#else
  return {"cyclic", "sliver"};
#endif
}

struct Drawn {
  render::Statistics statistics;
  double rmse = 0; ///< in 8-bit levels
  int largest = 0;
  double over_4 = 0; ///< share of pixels
};

Drawn draw(const std::string& scene, const std::string& golden, render::Settings settings) {
  const png::Picture wanted = png::read(HALFTONE_SOURCE_DIR "/tests/golden/" + golden + ".png");
  const auto read = scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + scene + ".toml");
  REQUIRE(wanted.width == read.image.width);
  REQUIRE(wanted.height == read.image.height);
  Drawn drawn;
  double sum = 0;
  int pixels_over_4 = 0;
  drawn.statistics = render::render(read, settings, [&](const render::Row& row) {
    for (std::size_t pixel = 0; pixel < row.radiance.size(); ++pixel) {
      int most = 0;
      for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
        const int difference = std::abs(row.rgb[i] - wanted.rgb[row.y * row.rgb.size() + i]);
        sum += difference * difference;
        most = std::max(most, difference);
      }
      drawn.largest = std::max(drawn.largest, most);
      if (most > 4) ++pixels_over_4;
    }
  });
  drawn.rmse = std::sqrt(sum / static_cast<double>(wanted.rgb.size()));
  drawn.over_4 = pixels_over_4 / (1.0 * read.image.width * read.image.height);
  return drawn;
}

void check(const Drawn& drawn, double rmse) {
  INFO("rmse " << drawn.rmse << ", largest " << drawn.largest << ", over 4 levels " << drawn.over_4);
  CHECK(drawn.rmse < rmse);
  CHECK(drawn.over_4 <= 0.001);
  CHECK(drawn.largest <= 16);
}

} // namespace

TEST_CASE(
    "by default every scene is within 0.3 levels of the exact picture, and no pixel is off by more than 16") {
  for (const std::string& name : scenes()) {
    INFO(name);
    check(draw(name, name, {}), 0.3);
  }
}

TEST_CASE("flat opaque things are within one level everywhere, without a ray") {
  const Drawn drawn = draw("opaque", "opaque", {});
  INFO("rmse " << drawn.rmse);
  CHECK(drawn.largest <= 1);
  CHECK(drawn.statistics.rays.eye == 0);
  CHECK(drawn.statistics.rays.shadow == 0);
  CHECK(drawn.statistics.traced_pixels == 0);
}

TEST_CASE("scanline is within 0.3 levels of its pictures, without a ray") {
  for (const std::string name : {"fig9a", "fig9b", "mirrors"}) {
    INFO(name);
    const Drawn drawn = draw(name, "scanline/" + name, {.mode = render::Mode::scanline});
    check(drawn, 0.3);
    CHECK(drawn.statistics.rays.eye == 0);
    CHECK(drawn.statistics.rays.shadow == 0);
  }
}

#if HALFTONE_LATTICE < 10 // under sanitizers it would take an hour
TEST_CASE("the error stays under the quality that is asked for") {
  for (const std::string& name : scenes()) {
    for (const double quality : {0.5, 1.0, 2.0}) {
      const Drawn drawn = draw(name, name, {.quality = quality});
      INFO(name << " at quality " << quality << ": rmse " << drawn.rmse);
      CHECK(drawn.rmse < quality);
    }
  }
}
#endif
