#include "random_surfaces.h"
#include "round_grid.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace halftone::scene;
using halftone::core::Vec3;

namespace {

constexpr double reach = 7, tolerance = reach * 0x1p-36;

} // namespace

TEST_CASE("a grid finds spheres that coincide, among thousands") {
  Random random{std::mt19937_64(6)};
  RoundGrid grid(reach, tolerance);
  std::vector<SphereSurface> spheres;
  std::size_t listed = 0;
  for (int k = 0; k < 20'000; ++k) {
    // One in four about the same center.
    const Vec3 center = k % 4 == 0 ? Vec3{1, -2, 3} : random.direction() * random.number(0, reach);
    spheres.push_back({center, random.number(0.1, reach)});
    grid.insert(spheres.back(), k);
  }
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    SphereSurface moved = spheres[k];
    const double share = random.number(0, 1);
    moved.center += random.direction() * (tolerance * share);
    moved.radius += tolerance * (1 - share) * (random.number(-1, 1) < 0 ? -1 : 1);
    const auto found = grid.near(moved);
    REQUIRE(std::ranges::is_sorted(found));
    REQUIRE(std::ranges::binary_search(found, static_cast<int>(k)));
    listed += found.size();
  }
  CHECK(listed < 2 * spheres.size()); // of 20,000 each
}

TEST_CASE("a grid finds cones about one axis, whichever way it is turned") {
  Random random{std::mt19937_64(7)};
  RoundGrid grid(reach, tolerance);
  std::vector<ConeSurface> cones;
  std::size_t listed = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Vec3 axis = k % 2 == 0 ? Vec3{0, 0, 1} : random.direction(); // most things stand upright
    cones.push_back(
        {random.direction() * random.number(0, reach), axis, random.number(0.1, 2), random.number(-1, 1)});
    grid.insert(cones.back(), k);
  }
  for (std::size_t k = 0; k < cones.size(); ++k) {
    // From another point within the tolerance of the axis, which is turned by up to the angle.
    const ConeSurface& cone = cones[k];
    const Vec3 across = glm::normalize(glm::cross(cone.axis, random.direction()));
    const double middle = -glm::dot(cone.origin, cone.axis);
    const double half =
        std::sqrt(std::max(0.0, reach * reach - glm::dot(cone.origin, cone.origin) + middle * middle));
    ConeSurface other = cone;
    other.origin +=
        cone.axis * (middle + random.number(-half, half)) + across * random.number(-tolerance, tolerance);
    const double sine = random.number(0, halftone::core::parallel);
    other.axis = cone.axis * std::sqrt(1 - sine * sine) + across * sine;
    if (random.number(-1, 1) < 0) other.axis = -other.axis;
    const auto found = grid.near(other);
    REQUIRE(std::ranges::is_sorted(found));
    REQUIRE(std::ranges::binary_search(found, static_cast<int>(k)));
    listed += found.size();
  }
  CHECK(listed < 4 * cones.size());
}

TEST_CASE("a round grid looks into few cells at any tolerance") {
  for (const double wide : {0x1p-30, 1.0, 1e9, 1e59}) { // the extent may be a polygon's alone
    RoundGrid grid(1, wide);
    for (int k = 0; k < 9; ++k) grid.insert(SphereSurface{{k / 9.0, 0, 0}, 0.1}, k);
    for (int k = 9; k < 18; ++k) grid.insert(ConeSurface{{(k - 9) / 9.0, 0, 0}, {0, 1, 0}, 0.1, 0}, k);
    INFO("tolerance " << wide);
    CHECK(std::ranges::binary_search(grid.near(SphereSurface{{4 / 9.0, 0, 0}, 0.1}), 4));
    CHECK(std::ranges::binary_search(grid.near(ConeSurface{{4 / 9.0, 0.5, 0}, {0, -1, 0}, 0.1, 0}), 13));
  }
}
