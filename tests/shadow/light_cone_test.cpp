#include "light_cone.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace halftone;
using core::Vec3;

TEST_CASE("cones that can shadow each other have directions in common") {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> coordinate(-1, 1), magnitude(-9, 0.3);
  const auto point = [&] { return Vec3{coordinate(random), coordinate(random), coordinate(random)}; };
  const Vec3 light{0.3, -0.2, 0.1};
  int shadowing = 0, apart = 0;
  for (int k = 0; k < 300'000; ++k) {
    // The second in about the direction of the first, both of any size, and sometimes around the light.
    const double size = std::pow(10, magnitude(random)), other = std::pow(10, magnitude(random));
    const Vec3 at = point(), place = light + (at - light) * 2.0 + point() * 3.0 * (size + other);
    std::vector<Vec3> first, second;
    for (int c = 0; c < 4; ++c) {
      first.push_back(at + point() * size);
      second.push_back(place + point() * other);
    }
    const shadow::LightCone a(light, first, 0), b(light, second, 0);
    if (!a.directions().meets(b.directions())) ++apart;
    if (!a.can_shadow(b) && !b.can_shadow(a)) continue;
    ++shadowing;
    INFO("seed 61, pair " << k);
    REQUIRE(a.directions().meets(b.directions()));
  }
  CHECK(shadowing > 50'000);
  CHECK(apart > 50'000);
}
