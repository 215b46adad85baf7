#include "turn.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace halftone;
using view::ScreenPoint;
using view::ScreenPolygon;

namespace {

__extension__ using Wide = __int128;

int sign(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Of points whose coordinates are whole multiples of 2^-45, below 2^9.
int wide_turn(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  const auto whole = [](double coordinate) { return static_cast<Wide>(std::ldexp(coordinate, 45)); };
  const Wide ax = whole(a.x), ay = whole(a.y);
  return sign((whole(b.x) - ax) * (whole(c.y) - ay) - (whole(b.y) - ay) * (whole(c.x) - ax));
}

class RandomPoints {
public:
  double number(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  /// A whole multiple of 2^-44.
  static double on_grid(double coordinate) { return std::ldexp(std::round(std::ldexp(coordinate, 44)), -44); }
  double position() { return on_grid(number(0, 500)); }
  double near(double coordinate, int steps) {
    return coordinate + std::ldexp(std::round(number(-steps, steps)), -44);
  }
  ScreenPoint near(const ScreenPoint& point, int steps) {
    return {near(point.x, steps), near(point.y, steps)};
  }

private:
  std::mt19937_64 random_{5};
};

bool is_convex(const ScreenPolygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (view::exact_turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) <= 0) return false;
  return true;
}

} // namespace

TEST_CASE("which way three points turn is exact") {
  RandomPoints random;
  int straight = 0, hard = 0;
  for (int i = 0; i < 200'000; ++i) {
    const ScreenPoint a{random.position(), random.position()}, b{random.position(), random.position()};
    // About on the line, at a few units in the last place from it; or near to an end.
    const double along = random.number(-1, 2);
    const ScreenPoint on{random.on_grid(a.x + along * (b.x - a.x)),
                         random.on_grid(a.y + along * (b.y - a.y))};
    ScreenPoint c = i % 3 == 0 ? random.near(b, 3) : random.near(on, 2);
    if (i % 7 == 0) c = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    INFO("case " << i);
    const int wanted = wide_turn(a, b, c);
    REQUIRE(view::exact_turn(a, b, c) == wanted);
    REQUIRE(view::exact_turn(b, a, c) == -wanted);
    const double rounded = view::turn(a, b, c);
    straight += wanted == 0;
    hard += (rounded > 0) - (rounded < 0) != wanted;
  }
  CHECK(straight > 1'000);
  CHECK(hard > 1'000); // where rounding says something else
}

TEST_CASE("the hull is convex however near to each other points lie") {
  RandomPoints random;
  for (int i = 0; i < 5'000; ++i) {
    std::vector<ScreenPoint> points;
    for (int k = 0; k < 6; ++k) {
      points.push_back({random.position(), random.position()});
      for (int twin = 0; twin < 3; ++twin) points.push_back(random.near(points.back(), 2));
    }
    const auto hull = view::convex_hull(points);
    INFO("case " << i);
    REQUIRE(hull);
    REQUIRE(is_convex(*hull));
    for (const ScreenPoint& p : points)
      for (std::size_t k = 0; k < hull->size(); ++k)
        REQUIRE(view::exact_turn((*hull)[k], (*hull)[(k + 1) % hull->size()], p) >= 0);
  }
}
