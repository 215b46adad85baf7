// The benchmark's own arithmetic, and its contender on Embree against the reference.

#include "contender.h"
#include "costs.h"
#include "curve.h"
#include "fit.h"
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

TEST_CASE("a straight line through points, and how much it explains") {
  const Fit exact = fit({{1, 5}, {2, 7}, {4, 11}});
  CHECK(exact.at_zero == Approx(3));
  CHECK(exact.slope == Approx(2));
  CHECK(exact.r_squared == Approx(1));
  // The middle one is off the line through the others by 3: residues 1, -2, 1 of a variance of 14 in all.
  const Fit off = fit({{0, 0}, {1, 0}, {2, 6}});
  CHECK(off.at_zero == Approx(-1));
  CHECK(off.slope == Approx(3));
  CHECK(off.r_squared == Approx(0.75));
}

TEST_CASE("the more prisms are of glass, the more pixels are traced") {
  CostTable table = traced_area_by_number();
  for (Run& run : table.runs) { // in time
    run.content.image.width /= 8;
    run.content.image.height /= 8;
  }
  time_runs(table, {.repetitions = 1}, [](const std::string&) {});
  CHECK(table.runs.front().traced_pixels == 0);
  for (std::size_t i = 1; i < table.runs.size(); ++i) {
    INFO(table.runs[i].setting);
    CHECK(table.runs[i].runs == 1);
    CHECK(table.runs[i].traced_pixels > table.runs[i - 1].traced_pixels);
  }
}

TEST_CASE("our picture survives in other units and far away") {
  Subject subject{"fig9a", scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/fig9a.toml"), {}};
  subject.scene.image.width /= 10; // in time
  subject.scene.image.height /= 10;
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
