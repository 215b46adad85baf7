#include <halftone/geometry/bounding.h>
#include <halftone/view/screen.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

// The polyhedra around round shapes: that they contain them, and how much they leave empty on the screen (the
// paper's figure 3) against boxes along the world's axes and against the paper's four-sided ones.

using namespace halftone;
using core::Vec3;

namespace {

class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const double length = glm::length(v);
      if (length > 0.1 && length < 1) return v / length;
    }
  }

private:
  std::mt19937_64 engine_;
};

scene::World world_of(const scene::Shape& shape) {
  scene::Scene built;
  built.camera = {{9, 9, 9}, {0, 0, 0}, {0, 0, 1}, 40};
  built.materials.push_back({});
  built.objects.resize(1);
  built.objects[0].shape = shape;
  return scene::make_world(built);
}

/// Points whose convex hull is the shape.
std::vector<Vec3> points_of(const scene::Shape& shape) {
  std::vector<Vec3> points;
  constexpr int turns = 96;
  if (const auto* sphere = std::get_if<scene::Sphere>(&shape)) {
    for (int i = 0; i <= turns / 2; ++i)
      for (int k = 0; k < turns; ++k) {
        const double latitude = std::numbers::pi * i * 2 / turns, turn = 2 * std::numbers::pi * k / turns;
        points.push_back(sphere->center + sphere->radius * Vec3{std::sin(latitude) * std::cos(turn),
                                                                std::sin(latitude) * std::sin(turn),
                                                                std::cos(latitude)});
      }
    return points;
  }
  const auto& frustum = std::get<scene::Frustum>(shape);
  const Vec3 axis = glm::normalize(frustum.top - frustum.base);
  const Vec3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  for (int k = 0; k < turns; ++k) {
    const double turn = 2 * std::numbers::pi * k / turns;
    const Vec3 out = u * std::cos(turn) + glm::cross(axis, u) * std::sin(turn);
    points.push_back(frustum.base + out * frustum.base_radius);
    points.push_back(frustum.top + out * frustum.top_radius);
  }
  return points;
}

scene::Shape random_shape(Random& random, int kind) {
  const Vec3 base{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
  const Vec3 top = base + random.direction() * random.uniform(0.3, 4);
  const double radius = random.uniform(0.2, 2);
  if (kind == 0) return scene::Sphere{base, radius};
  return scene::Frustum{base, top, radius,
                        kind == 1   ? radius
                        : kind == 2 ? 0
                                    : radius * random.uniform(0.1, 0.9)};
}

/// Area of the outline of the points' hull, seen along a direction.
double area_along(const Vec3& direction, const std::vector<Vec3>& points) {
  const Vec3 u =
      glm::normalize(glm::cross(direction, std::abs(direction.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = glm::cross(direction, u);
  std::vector<view::ScreenPoint> seen;
  for (const Vec3& p : points) seen.push_back({glm::dot(p, u), glm::dot(p, v)});
  const auto outline = view::convex_hull(seen);
  REQUIRE(outline);
  double area = 0;
  for (std::size_t i = 0; i < outline->size(); ++i) {
    const auto &a = (*outline)[i], &b = (*outline)[(i + 1) % outline->size()];
    area += (a.x * b.y - b.x * a.y) / 2;
  }
  return std::abs(area);
}

std::vector<Vec3> box_around(const std::vector<Vec3>& points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z});
  return corners;
}

/// Area that each leaves empty, as a share of the shape's own, averaged over shapes and directions.
struct Empty {
  double box = 0;
  double four = 0;
  double eight = 0;
};

Empty empty_of(int kind) {
  Random random(kind + 100);
  Empty empty;
  constexpr int cases = 400;
  for (int i = 0; i < cases; ++i) {
    const scene::Shape shape = random_shape(random, kind);
    const scene::World world = world_of(shape);
    const Vec3 direction = random.direction();
    const std::vector<Vec3> points = points_of(shape);
    const double own = area_along(direction, points);
    const auto share = [&](const std::vector<Vec3>& around) {
      return (area_along(direction, around) / own - 1) / cases;
    };
    empty.box += share(box_around(points));
    empty.four += share(geometry::bounding_hull(world, world.bodies[0], 4).vertices);
    empty.eight += share(geometry::bounding_hull(world, world.bodies[0]).vertices);
  }
  return empty;
}

} // namespace

TEST_CASE("the hull of a round shape contains it, to the rounding of its coordinates") {
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    const scene::Shape shape = random_shape(random, i % 4);
    const scene::World world = world_of(shape);
    const geometry::Hull hull = geometry::bounding_hull(world, world.bodies[0]);
    INFO("case " << i);
    REQUIRE(hull.planes.size() == hull.faces.size());
    for (const scene::Plane& plane : hull.planes)
      for (const Vec3& p : points_of(shape)) REQUIRE(glm::dot(plane.normal, p) - plane.offset < 1e-13);
  }
}

TEST_CASE("the faces of a hull are flat, convex and close it") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const scene::World world = world_of(random_shape(random, i % 4));
    const geometry::Hull hull = geometry::bounding_hull(world, world.bodies[0]);
    INFO("case " << i);
    int sides = 0;
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      sides += static_cast<int>(hull.faces[f].size());
      for (const int corner : hull.faces[f])
        REQUIRE(std::abs(glm::dot(hull.planes[f].normal, hull.vertices[corner]) - hull.planes[f].offset) <
                1e-12);
      for (const Vec3& vertex : hull.vertices)
        REQUIRE(glm::dot(hull.planes[f].normal, vertex) - hull.planes[f].offset < 1e-12);
    }
    REQUIRE(static_cast<int>(hull.vertices.size()) - sides / 2 + static_cast<int>(hull.faces.size()) == 2);
  }
}

TEST_CASE("hulls leave less empty than four-sided ones, and those less than boxes along the world's axes") {
  for (const auto& [kind, name] :
       {std::pair{0, "sphere"}, std::pair{1, "cylinder"}, std::pair{2, "cone"}, std::pair{3, "frustum"}}) {
    const Empty empty = empty_of(kind);
    INFO(name << ": box " << empty.box << ", four sides " << empty.four << ", eight " << empty.eight);
    CHECK(empty.eight < empty.four / 2);
    CHECK(empty.four < empty.box);
    CHECK(empty.eight < 0.2);
  }
}
