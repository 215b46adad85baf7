#include "drawn.h"
#include "support/effort.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

// Default settings against pictures of another program, every pixel.

using namespace halftone;
using test::draw;
using test::Drawn;

namespace {

/// Under sanitizers only what is drawn quickly.
std::vector<std::string> scenes() {
  if (test::sanitized) return {"cyclic", "sliver"};
  return {"fig9a", "fig9b", "contact", "nested", "inside", "mirrors", "sliver", "cyclic", "opaque", "round"};
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

TEST_CASE("the error stays under the quality that is asked for", test::long_when_sanitized) {
  for (const std::string& name : scenes()) {
    for (const double quality : {0.5, 1.0, 2.0}) {
      const Drawn drawn = draw(name, name, {.quality = quality});
      INFO(name << " at quality " << quality << ": rmse " << drawn.rmse);
      CHECK(drawn.rmse < quality);
    }
  }
}
