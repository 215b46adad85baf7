#include <halftone/view/screen.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace halftone;
using view::ScreenPoint;
using view::ScreenPolygon;

namespace {

view::Screen screen_of(const core::Vec3& eye, const core::Vec3& target, double fov, int width, int height) {
  scene::Scene built;
  built.materials.push_back({});
  built.camera = {eye, target, {0, 0, 1}, fov};
  built.image.width = width;
  built.image.height = height;
  return view::Screen(scene::make_world(built).camera);
}

bool inside(const ScreenPolygon& polygon, double x, double y) {
  int positive = 0, negative = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ScreenPoint& a = polygon[i];
    const ScreenPoint& b = polygon[(i + 1) % polygon.size()];
    const double turn = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    positive += turn > 0;
    negative += turn < 0;
  }
  return positive == 0 || negative == 0;
}

/// An ellipse, and a line: direction and height over the middle.
struct CutEllipse {
  ScreenPoint middle;
  double long_side, short_side, turned;
  ScreenPoint line;
  double line_at;

  ScreenPoint at(double angle) const {
    const double u = long_side * std::cos(angle), v = short_side * std::sin(angle);
    return {middle.x + u * std::cos(turned) - v * std::sin(turned),
            middle.y + u * std::sin(turned) + v * std::cos(turned)};
  }
  double height(const ScreenPoint& p) const {
    return line.x * (p.x - middle.x) + line.y * (p.y - middle.y) + line_at;
  }
};

/// As chords: the corners on the inner side of the line, and where edges cross that.
ScreenPolygon in_chords(const CutEllipse& ellipse, int sides) {
  std::vector<ScreenPoint> points;
  const auto corner = [&](int k) { return ellipse.at(2 * 3.14159265358979 * (k % sides) / sides); };
  for (int k = 0; k < sides; ++k) {
    const ScreenPoint a = corner(k), b = corner(k + 1);
    const double height_a = ellipse.height(a), height_b = ellipse.height(b);
    if (height_a >= 0) points.push_back(a);
    if ((height_a >= 0) == (height_b >= 0)) continue;
    const double s = height_a / (height_a - height_b);
    points.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
  }
  return view::convex_hull(std::move(points)).value_or(ScreenPolygon{});
}

} // namespace

TEST_CASE("a point projects to the position whose ray passes through it") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const view::Screen screen = screen_of({3, -7, 2}, {0, 0, 1}, 50, 320, 200);
  for (int i = 0; i < 1'000; ++i) {
    const double x = 160 + 160 * uniform(random), y = 100 + 100 * uniform(random),
                 depth = 5 + 4 * uniform(random);
    const view::ClipPoint p = screen.clip_point(screen.direction(x, y) * depth);
    INFO("case " << i);
    REQUIRE(p.depth == Approx(depth));
    REQUIRE((p.right / p.depth + 1) * 160 == Approx(x).margin(1e-10));
    REQUIRE((1 - p.up / p.depth) * 100 == Approx(y).margin(1e-10));
  }
}

TEST_CASE(
    "clipping keeps exactly the part of a polygon that rays through the screen meet, behind the eye too") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int on_screen = 0, crossing_eye = 0;
  for (int i = 0; i < 400; ++i) {
    const view::Screen screen = screen_of({0, 0, 0}, {1, 0, 0}, 60, 100, 80);
    const core::Vec3 center = core::Vec3{uniform(random), uniform(random), uniform(random)} * 4.0;
    const core::Vec3 u = core::Vec3{uniform(random), uniform(random), uniform(random)} * 6.0;
    const core::Vec3 v = core::Vec3{uniform(random), uniform(random), uniform(random)} * 6.0;
    const std::vector<core::Vec3> corners{center + u, center + v, center - u, center - v};
    std::vector<view::ClipPoint> projected;
    int behind = 0;
    for (const core::Vec3& p : corners) {
      projected.push_back(screen.clip_point(p));
      behind += projected.back().depth < 0;
    }
    crossing_eye += behind > 0 && behind < 4;
    const auto polygon = screen.clipped(projected);
    const core::Vec3 normal = glm::cross(u, v);
    for (int k = 0; k < 50; ++k) {
      const double x = 50 + 50 * uniform(random), y = 40 + 40 * uniform(random);
      const core::Vec3 direction = screen.direction(x, y);
      const double t = glm::dot(normal, center) / glm::dot(normal, direction);
      const core::Vec3 hit = direction * t - center;
      // hit = a u + b v lies in the rhombus where |a| + |b| <= 1.
      const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), det = uu * vv - uv * uv;
      const double a = (glm::dot(hit, u) * vv - glm::dot(hit, v) * uv) / det;
      const double b = (glm::dot(hit, v) * uu - glm::dot(hit, u) * uv) / det;
      const double margin = 1 - std::abs(a) - std::abs(b);
      if (std::abs(margin) < 1e-9) continue;
      INFO("seed 2, polygon " << i << " at " << x << ", " << y);
      REQUIRE((polygon && inside(*polygon, x, y)) == (t > 0 && margin > 0));
      on_screen += t > 0 && margin > 0;
    }
  }
  CHECK(on_screen > 1'000);
  CHECK(crossing_eye > 50);
}

TEST_CASE("the inverse depth of a plane is that of the ray's hit") {
  const view::Screen screen = screen_of({1, -6, 2}, {0, 0, 1}, 40, 64, 48);
  const scene::Plane plane{glm::normalize(core::Vec3{0.2, -0.9, 0.4}), 0.3};
  const auto inverse = screen.inverse_depth(plane);
  REQUIRE(inverse);
  for (const double x : {0.0, 10.5, 64.0})
    for (const double y : {0.0, 30.25, 48.0}) {
      const core::Vec3 hit = core::Vec3{1, -6, 2} + screen.direction(x, y) / inverse->at(x, y);
      CHECK(glm::dot(plane.normal, hit) == Approx(plane.offset).margin(1e-12));
    }
  CHECK_FALSE(screen.inverse_depth({{0, 0, 1}, 2}));
}

TEST_CASE("polygons that share an edge end and begin at the same position, to the bit") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 100);
  for (int i = 0; i < 2'000; ++i) {
    const ScreenPoint a{uniform(random), uniform(random)}, b{uniform(random), uniform(random)};
    const ScreenPoint left{-10, (a.y + b.y) / 2}, right{110, (a.y + b.y) / 2};
    const double y = a.y + (b.y - a.y) * uniform(random) / 100;
    const auto first = view::extent_at({a, b, left}, y), second = view::extent_at({a, right, b}, y);
    INFO("seed 3, case " << i);
    REQUIRE(first);
    REQUIRE(second);
    REQUIRE(first->right == second->left);
  }
}

TEST_CASE("the hull contains all of its points and has no superfluous corner") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 10);
  for (int i = 0; i < 200; ++i) {
    std::vector<ScreenPoint> points;
    for (int k = 0; k < 12; ++k) points.push_back({uniform(random), uniform(random)});
    const auto hull = view::convex_hull(points);
    REQUIRE(hull);
    for (const ScreenPoint& p : points) {
      const bool corner =
          std::any_of(hull->begin(), hull->end(), [&](auto& h) { return h.x == p.x && h.y == p.y; });
      CHECK((corner || inside(*hull, p.x, p.y)));
    }
  }
  CHECK_FALSE(view::convex_hull({{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
  CHECK_FALSE(view::convex_hull({{1, 1}, {1, 1}, {1, 1}}));
  CHECK(view::convex_hull({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {0, 0}})->size() == 4);
}

TEST_CASE("what fills the screen begins and ends exactly with it") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const view::Screen screen =
        screen_of({0, 0, 1 + 0.5 * uniform(random)}, {3, uniform(random), 0}, 40, 321, 213);
    std::vector<view::ClipPoint> corners;
    for (const core::Vec3& p : {core::Vec3{-90, -90, 0}, {90, -80, 0}, {90, 70, 0}, {-90, 90, 0}})
      corners.push_back(screen.clip_point(p - screen.camera().eye));
    const auto polygon = screen.clipped(corners);
    REQUIRE(polygon);
    const auto extent = view::extent_at(*polygon, 212.5);
    INFO("case " << i);
    REQUIRE(extent);
    CHECK(extent->left == 0);
    CHECK(extent->right == 321);
  }
}

TEST_CASE("what more chords add to a part of an ellipse is found whatever angles it has") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int compared = 0;
  for (int i = 0; i < 3'000; ++i) {
    const CutEllipse shape{{300 * uniform(random), 300 * uniform(random)},
                           100,
                           100 * std::pow(10, 1.5 * uniform(random) - 1.5),
                           4 * uniform(random),
                           {uniform(random), uniform(random)},
                           60 * uniform(random)};
    const int sides = 16 << i % 5;
    const ScreenPolygon coarse = in_chords(shape, sides), fine = in_chords(shape, 2 * sides);
    if (coarse.empty() || fine.empty()) continue;
    double most = 0; // beside every edge that is long enough to have a direction
    for (const ScreenPoint& c : fine) {
      double outside = -1e9;
      for (std::size_t k = 0; k < coarse.size(); ++k) {
        const ScreenPoint &a = coarse[k], &b = coarse[(k + 1) % coarse.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length > 1e-6)
          outside = std::max(outside, ((b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y)) / length);
      }
      most = std::max(most, outside);
    }
    const double found = view::excess(fine, coarse);
    INFO("case " << i << ": " << found << " of " << most);
    CHECK(found <= most * (1 + 1e-9));
    CHECK(found >= most * 0.9);
    ++compared;
  }
  CHECK(compared > 2'000);
}
