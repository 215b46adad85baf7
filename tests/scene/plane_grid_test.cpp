#include "plane_grid.h"
#include "random_surfaces.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace halftone::scene;
using halftone::core::Vec3;

TEST_CASE("a grid finds every plane that is near, whichever way it is turned, among thousands that are not") {
  constexpr double reach = 7, parallel = 0x1p-10, tolerance = 7 * 0x1p-36;
  Random random{std::mt19937_64(5)};
  PlaneGrid grid(reach, parallel, tolerance);
  std::vector<Plane> planes;
  std::size_t listed = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Vec3 normal = k % 4 == 0 ? Vec3{0, 0, 1} : random.direction(); // boxes have many parallel faces
    planes.push_back({normal, random.number(-reach, reach)});
    grid.insert(planes.back(), k);
  }
  for (std::size_t k = 0; k < planes.size(); ++k) {
    // Through a point that is within the tolerance of the plane, turned by up to the angle.
    const Plane& plane = planes[k];
    const Vec3 across = glm::normalize(glm::cross(plane.normal, random.direction()));
    const Vec3 point =
        plane.normal * (plane.offset + random.number(-tolerance, tolerance)) +
        across * random.number(-1, 1) * std::sqrt(std::max(0.0, reach * reach - plane.offset * plane.offset));
    const double sine = random.number(0, parallel);
    Vec3 normal = plane.normal * std::sqrt(1 - sine * sine) + across * sine;
    if (random.number(-1, 1) < 0) normal = -normal;
    const auto found = grid.near({normal, glm::dot(normal, point)}, point);
    REQUIRE(std::ranges::is_sorted(found));
    REQUIRE(std::ranges::binary_search(found, static_cast<int>(k)));
    listed += found.size();
  }
  CHECK(listed < 20 * planes.size()); // of 20,000 each
}

TEST_CASE("a grid looks into a few cells however far its tolerance goes") {
  for (const double tolerance : {0x1p-30, 1.0, 1e4, 1e9, 1e59}) { // the extent may be a sphere's alone
    PlaneGrid grid(1, 0x1p-10, tolerance);
    for (int k = 0; k < 9; ++k) grid.insert({{0, 0, 1}, k / 8.0}, k);
    const auto found = grid.near({{0, 0, -1}, -0.5}, {0.5, 0, 0.5});
    INFO("tolerance " << tolerance);
    CHECK(std::ranges::binary_search(found, 4));
    if (tolerance >= 1) CHECK(found.size() == 9);
  }
}
