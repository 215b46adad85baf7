#include "intervals.h"
#include "meeting.h"
#include "support/random_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace halftone;

namespace {

/// All bodies whose surface is met at the first distance.
std::vector<int> first_met(const scene::World& world, double x, double y) {
  const reference::Line line{world.camera.eye, world.camera.direction(x, y), -1, false};
  const auto meeting =
      reference::next_meeting(world, line, reference::solids_around(world, world.camera.eye));
  std::vector<int> bodies;
  if (!meeting) return bodies;
  if (meeting->ahead.opaque.body >= 0) bodies.push_back(meeting->ahead.opaque.body);
  for (const auto& met : meeting->ahead.entries) bodies.push_back(met.body);
  for (const auto& met : meeting->exits) bodies.push_back(met.body);
  return bodies;
}

bool contains(const std::vector<int>& bodies, int body) {
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

} // namespace

TEST_CASE("intervals tile the scanline and agree with dense eye rays, and no candidate is missing") {
  int flat = 0, traced = 0, background = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    test::RandomScene random(seed);
    const scene::World world =
        scene::make_world(random.make({9, seed % 3 != 0, seed % 2 == 0, seed % 4 < 2}));
    const scan::Frame frame(world);
    order::Order order(world, frame.hulls);
    for (int line = 0; line < 40; ++line) {
      const double y = random.uniform(0, 48);
      const auto active = scan::active_in(frame, std::floor(y), std::floor(y) + 1);
      const auto intervals = scan::visible_intervals(frame, active, order, y);
      REQUIRE(intervals.front().left == 0);
      REQUIRE(intervals.back().right == 64);
      for (std::size_t i = 0; i + 1 < intervals.size(); ++i)
        REQUIRE(intervals[i].right == intervals[i + 1].left);
      for (const scan::Interval& interval : intervals) {
        REQUIRE(interval.left < interval.right);
        for (int k = 0; k < 6; ++k) {
          const double x = interval.left + (interval.right - interval.left) * random.uniform(0.01, 0.99);
          // Nearer to an end than this, rounding decides which side a ray falls on.
          if (std::min(x - interval.left, interval.right - x) < 1e-7) continue;
          const std::vector<int> met = first_met(world, x, y);
          const int face_body = interval.face < 0 ? -1 : frame.faces[interval.face].body;
          INFO("seed " << seed << " at " << x << ", " << y << ", face of body " << face_body << ", met "
                       << (met.empty() ? -1 : met[0]) << " and " << met.size() << " in all, candidates "
                       << interval.candidates.size());
          if (interval.candidates.empty()) {
            if (face_body < 0)
              REQUIRE(met.empty());
            else
              REQUIRE(contains(met, face_body));
            ++(face_body < 0 ? background : flat);
          } else {
            for (const int body : met) REQUIRE((body == face_body || contains(interval.candidates, body)));
            ++traced;
          }
        }
      }
    }
  }
  CHECK(flat > 5'000);
  CHECK(traced > 5'000);
  CHECK(background > 2'000);
}

TEST_CASE(
    "three beams that overlap in a cycle, and two boxes that pass through each other, need nothing special") {
  const auto beam = [](double turn) {
    scene::Object object;
    object.shape = scene::Box{{-2.2, -0.97, -0.1}, {2.2, -0.53, 0.1}};
    object.placement = {1, {0, 16, turn}, {0, 0, 1.2}};
    return object;
  };
  scene::Scene built;
  built.image.width = 64;
  built.image.height = 48;
  built.camera = {{-0.7, -7, 6}, {0, 0, 0.6}, {0, 0, 1}, 40};
  built.materials.push_back({});
  built.objects = {beam(0), beam(120), beam(240), beam(0)};
  built.objects[3].placement.rotate = {90, 16, 30};
  const scene::World world = scene::make_world(built);
  const scan::Frame frame(world);
  order::Order order(world, frame.hulls);
  for (double y = 0.25; y < 48; y += 0.5)
    for (const scan::Interval& interval :
         scan::visible_intervals(frame, scan::active_in(frame, y, y), order, y)) {
      for (const double part : {0.02, 0.5, 0.98}) {
        const double x = interval.left + (interval.right - interval.left) * part;
        if (interval.right - interval.left < 1e-5) continue;
        const auto met = first_met(world, x, y);
        INFO("at " << x << ", " << y);
        if (interval.face < 0)
          REQUIRE(met.empty());
        else
          REQUIRE(contains(met, frame.faces[interval.face].body));
      }
    }
}
