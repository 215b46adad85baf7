// The benchmark's own arithmetic, and its contender on Embree against the reference.

#include "contender.h"
#include "curve.h"
#include "ours.h"
#include "survival.h"
#ifdef HALFTONE_HAS_EMBREE
#include "embree_contender.h"
#endif

#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace halftone;
using namespace halftone::bench;

TEST_CASE("time at equal error is interpolated in the logarithms") {
  // error = 1 / seconds^2, and a setting that another beats in both.
  const std::vector<Point> points{{1, 1}, {4, 1.0 / 16}, {2, 0.25}, {3, 0.9}};
  CHECK(seconds_at(points, 0.25).value() == Approx(2));
  CHECK(seconds_at(points, 0.5).value() == Approx(std::sqrt(2.0)));
  CHECK(seconds_at(points, 0.1).value() == Approx(std::sqrt(10.0)));
  CHECK(front(points).size() == 3);
  CHECK(slope(points).value() == Approx(-2));
}

TEST_CASE(
    "time at equal error is the fastest setting's where that is good enough, and none where no setting is") {
  const std::vector<Point> points{{2, 0.2}, {5, 0.1}};
  CHECK(seconds_at(points, 0.3).value() == 2);
  CHECK_FALSE(seconds_at(points, 0.05).has_value());
  CHECK_FALSE(seconds_at({}, 1).has_value());
  CHECK_FALSE(slope({{1, 1}}).has_value());
  CHECK(seconds_at({{1, 1}, {2, 0}}, 0.5).value() == 2);
}

TEST_CASE("every contender has settings, each with a name of its own") {
  std::vector<std::string> missing;
  for (const auto& contender : all_contenders(2, missing)) {
    INFO(contender->name());
    CHECK(contender->settings().size() > 3);
  }
  for (const std::string& line : missing) WARN(line);
}

TEST_CASE("our picture survives in other units and far away") {
  Subject subject{"fig9a", scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/fig9a.toml"), {}};
  subject.scene.image.width /= 4; // in time
  subject.scene.image.height /= 4;
  Contenders ours;
  add_ours(ours, 2);
  const Survivals result = survivals({subject}, ours, "no folder", [](const std::string&) {});
  REQUIRE(result.all.size() == 1);
  REQUIRE(result.all[0].off.size() == 3);
  for (const double off : result.all[0].off) CHECK(off < 0.1);
}

#ifdef HALFTONE_HAS_EMBREE
TEST_CASE("the contender on Embree draws what mode reference draws, at 8 x 8 samples") {
  for (const char* name : {"opaque", "round"}) {
    scene::Scene scene = scene::read_scene(std::string(HALFTONE_SOURCE_DIR "/scenes/") + name + ".toml");
    scene.image.width /= 2; // in time
    scene.image.height /= 2;
    const Levels reference =
        rendered(scene, {.mode = render::Mode::reference, .samples = 8, .threads = 2}).levels;
    INFO(name);
    CHECK(rmse(embree_evenly(scene, 8, false, 2), reference) < 1);
    CHECK(rmse(embree_adaptively(scene, {32, 8, 1}, 2).levels, reference) < 1);
  }
}
#endif
