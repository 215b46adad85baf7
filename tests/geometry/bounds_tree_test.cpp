#include "shapes.h"

#include <halftone/geometry/bounds_tree.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

// The hierarchy against its slow twin, which asks every box.

using namespace shapes;
using namespace halftone::geometry;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double pick(std::mt19937_64& random, const std::vector<double>& numbers) {
  return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random)];
}

/// Some are flat, some points, some reach to infinity, some stand many times at one place.
std::vector<Bounds> random_boxes(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> size(0, 1.5);
  std::vector<Bounds> boxes;
  for (int k = 0; k < count; ++k) {
    Vec3 low = random_point(random, 8), extent{size(random), size(random), size(random)};
    if (k % 3 == 0) low = glm::round(low), extent = glm::round(extent);
    if (k % 7 == 0) low = Vec3{1, 2, 3};
    if (k % 31 == 0) extent.x = infinity;
    if (k % 97 == 0) low.y = -infinity;
    boxes.push_back({low, low + extent});
  }
  return boxes;
}

/// Along axes and diagonals too, and from sides and corners of boxes.
Ray random_ray(std::mt19937_64& random, const std::vector<Bounds>& boxes) {
  Vec3 origin = random_point(random, 12), direction = random_direction(random);
  std::uniform_int_distribution<int> kind(0, 3);
  if (kind(random) == 0)
    for (int axis = 0; axis < 3; ++axis)
      direction[axis] = pick(random, {0.0, -0.0, 1.0, -1.0, 1e-310, -1e-200});
  const Bounds& box = boxes[std::uniform_int_distribution<std::size_t>(0, boxes.size() - 1)(random)];
  if (kind(random) == 0)
    for (int axis = 0; axis < 3; ++axis)
      if (const double side = pick(random, {box.low[axis], box.high[axis], 0}); std::isfinite(side))
        origin[axis] = side;
  return {origin, direction};
}

std::vector<int> sorted(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

} // namespace

TEST_CASE("a line finds all boxes that it passes, each once") {
  std::mt19937_64 random(51);
  std::size_t found = 0;
  for (const int count : {0, 1, 2, 5, 33, 400, 3000}) {
    const std::vector<Bounds> boxes = random_boxes(random, count);
    const BoundsTree tree(boxes);
    for (int k = 0; k < (count > 0 ? 2'000 : 0); ++k) {
      const Ray ray = random_ray(random, boxes);
      const double limit = pick(random, {infinity, 0.0, 1.0, 5.0, -1.0});
      std::vector<int> asked, walked;
      for (int b = 0; b < count; ++b)
        if (ray.passes(boxes[b], limit)) asked.push_back(b);
      tree.along(ray, limit, [&](int b) {
        walked.push_back(b);
        return limit;
      });
      INFO("seed 51, " << count << " boxes, ray " << k);
      REQUIRE(sorted(walked) == asked);
      found += asked.size();
    }
  }
  CHECK(found > 10'000);
}

TEST_CASE("a box finds all boxes that it meets, each once") {
  std::mt19937_64 random(52);
  std::size_t found = 0;
  for (const int count : {1, 2, 5, 33, 400, 3000}) {
    const std::vector<Bounds> boxes = random_boxes(random, count);
    const BoundsTree tree(boxes);
    for (const Bounds& given : random_boxes(random, 500)) {
      std::vector<int> asked, walked;
      for (int b = 0; b < count; ++b)
        if (boxes[b].meets(given)) asked.push_back(b);
      tree.meeting(given, [&](int b) { walked.push_back(b); });
      INFO("seed 52, " << count << " boxes");
      REQUIRE(sorted(walked) == asked);
      found += asked.size();
    }
  }
  CHECK(found > 10'000);
}

TEST_CASE("a line passes a box whose points it goes through, to the bit") {
  std::mt19937_64 random(53);
  std::uniform_real_distribution<double> along(0, 30), share(0, 1);
  for (int k = 0; k < 200'000; ++k) {
    const Vec3 origin = random_point(random, 12), direction = random_direction(random);
    const double t = along(random);
    const Vec3 p = origin + direction * t;
    // The point may be off the line by its own rounding, a box that holds it by nothing else.
    const double blur = 0x1p-50 * (20 + t);
    const Bounds box{p - Vec3{blur, blur, blur + share(random)}, p + Vec3{blur, blur + share(random), blur}};
    INFO("seed 53, ray " << k);
    REQUIRE(Ray(origin, direction).passes(box, t));
  }
}

TEST_CASE("a shrinking limit leaves out what lies beyond it") {
  std::vector<Bounds> boxes;
  for (int k = 0; k < 1'000; ++k) boxes.push_back({Vec3{k * 1.0, -1, -1}, Vec3{k + 0.5, 1, 1}});
  const BoundsTree tree(boxes);
  for (const double from : {-1.0, 2000.0}) {
    int visited = 0, nearest = -1;
    const double forward = from < 0 ? 1 : -1;
    double limit = infinity;
    tree.along({Vec3{from, 0, 0}, Vec3{forward, 0, 0}}, infinity, [&](int b) {
      ++visited;
      const double t = forward > 0 ? b - from : from - (b + 0.5);
      if (t < limit) limit = t, nearest = b;
      return limit;
    });
    CHECK(nearest == (forward > 0 ? 0 : 999));
    CHECK(visited <= 8);
  }
  int visited = 0;
  tree.along({Vec3{-1, 0, 0}, Vec3{1, 0, 0}}, infinity, [&](int) { return ++visited, -1.0; });
  CHECK(visited == 1);
}

TEST_CASE("empty boxes are in no hierarchy") {
  const std::vector<Bounds> boxes{Bounds{}, Bounds{Vec3{0}, Vec3{1}}, Bounds{}};
  std::vector<int> found;
  BoundsTree(boxes).meeting({Vec3{-5}, Vec3{5}}, [&](int b) { found.push_back(b); });
  CHECK(found == std::vector<int>{1});
  BoundsTree(std::vector<Bounds>(3)).meeting({Vec3{-5}, Vec3{5}}, [&](int) { FAIL(); });
}
