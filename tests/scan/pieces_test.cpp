#include "pieces.h"

#include "support/effort.h"
#include "support/random_scene.h"

#include <halftone/geometry/bounding.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

// Areas of parts of pixels, against the same in quadruple precision (2^-112).

using namespace halftone;

namespace {

__extension__ typedef __float128 Quad;

struct QuadPoint {
  Quad x, y;
};

/// The area that a convex polygon leaves of pixel (x, y).
double quad_coverage(const view::ScreenPolygon& polygon, int x, int y) {
  std::vector<QuadPoint> part{
      {Quad(x), Quad(y)}, {Quad(x + 1), Quad(y)}, {Quad(x + 1), Quad(y + 1)}, {Quad(x), Quad(y + 1)}};
  Quad orientation = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    orientation += (Quad(polygon[i].x) - polygon[0].x) * (Quad(polygon[i + 1].y) - polygon[0].y) -
                   (Quad(polygon[i].y) - polygon[0].y) * (Quad(polygon[i + 1].x) - polygon[0].x);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const view::ScreenPoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const auto height = [&](const QuadPoint& p) {
      const Quad turn = (Quad(b.x) - a.x) * (p.y - a.y) - (Quad(b.y) - a.y) * (p.x - a.x);
      return orientation > 0 ? turn : -turn;
    };
    std::vector<QuadPoint> kept;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const QuadPoint &p = part[i], &q = part[(i + 1) % part.size()];
      const Quad hp = height(p), hq = height(q);
      if (hp >= 0) kept.push_back(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) {
        const Quad s = hp / (hp - hq);
        kept.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
      }
    }
    part = kept;
    if (part.size() < 3) return 0;
  }
  Quad twice = 0;
  for (std::size_t i = 1; i + 1 < part.size(); ++i)
    twice += (part[i].x - part[0].x) * (part[i + 1].y - part[0].y) -
             (part[i].y - part[0].y) * (part[i + 1].x - part[0].x);
  return static_cast<double>(twice / Quad(2));
}

/// The same by the engine; parts: of the pixel, which must tile it.
double coverage(const scan::RowOutline& row, scan::Pieces& pieces, int x, int y, double& parts) {
  parts = 1;
  if (!row.touched.contains(x)) return 0;
  if (row.full.contains(x)) return 1;
  scan::Piece inside = pieces.whole(x, y);
  parts = 0;
  for (const scan::RowEdge& edge : row.edges) {
    if (!edge.pixels.contains(x)) continue;
    const scan::Sides sides = pieces.cut(inside, edge.edge);
    if (sides.outside.count > 0) parts += pieces.area(sides.outside);
    inside = sides.inside;
    if (inside.count == 0) return 0;
  }
  parts += pieces.area(inside);
  return pieces.area(inside);
}

view::ScreenPolygon random_polygon(test::RandomScene& random) {
  std::vector<view::ScreenPoint> points;
  const double size = std::exp2(random.uniform(-4, 8));
  const double cx = random.uniform(0, 64), cy = random.uniform(0, 48);
  // Corners on borders of pixels, vertical and level edges among them.
  const auto coordinate = [&](double center) {
    const double value = center + random.uniform(-size, size);
    return random.uniform(0, 1) < 0.2 ? std::round(value) : value;
  };
  for (int k = 0; k < 8; ++k) points.push_back({coordinate(cx), coordinate(cy)});
  auto hull = view::convex_hull(points);
  return hull ? *hull : view::ScreenPolygon{{0, 0}, {1, 0}, {0, 1}};
}

} // namespace

TEST_CASE("the coverage of every pixel is within 1e-12 of exact arithmetic, and parts tile it") {
  scan::Pieces pieces;
  double worst = 0, worst_sum = 0;
  std::uint64_t partly = 0;
  for (std::uint64_t seed = 1; seed <= 400; seed += test::seed_step) {
    test::RandomScene random(seed);
    const view::ScreenPolygon polygon = random_polygon(random);
    const scan::Outline outline(polygon);
    for (int y = 0; y < 48; ++y) {
      const scan::RowOutline row = outline.in_row(y);
      for (int x = 0; x < 64; ++x) {
        double parts = 1;
        const double ours = coverage(row, pieces, x, y, parts), exact = quad_coverage(polygon, x, y);
        if (exact > 0 && exact < 1) ++partly;
        worst = std::max(worst, std::abs(ours - exact));
        if (ours > 0) worst_sum = std::max(worst_sum, std::abs(parts - 1));
        if (std::abs(ours - exact) > 1e-12)
          FAIL("seed " << seed << ", pixel " << x << ' ' << y << ": " << ours << ", exact " << exact);
      }
    }
  }
  INFO("worst " << worst << ", of sums " << worst_sum);
  CHECK(partly > 10000 / test::seed_step);
  CHECK(worst_sum < 1e-12);
}

namespace {

/// What curves on the screen look like, by the number of their chords.
class Curves {
public:
  view::ScreenPolygon circle(int chords) const {
    view::ScreenPolygon polygon;
    for (int k = 0; k < chords; ++k) {
      const double phi = 2 * std::numbers::pi * (k + 0.3) / chords;
      polygon.push_back({32.3 + 20.7 * std::cos(phi), 24.1 + 20.7 * std::sin(phi)});
    }
    return polygon;
  }

  view::ScreenPolygon sphere(int chords) const {
    return on_screen(geometry::tangent_circle(ball_, world_.camera.eye, world_.camera, chords));
  }

  view::ScreenPolygon frustum(int chords, int which) const {
    const scene::Frustum frustum{{-1, 0, 0.1}, {0.7 + 0.1 * which, 0.4 - 0.07 * which, 1.6}, 1, 0.4};
    return on_screen(geometry::inscribed_hull(frustum, world_.camera, chords).vertices);
  }

  view::ScreenPolygon shadow_of_sphere(int chords) const {
    const core::Vec3 light{-2.3, 1.7, 6};
    std::vector<core::Vec3> points = geometry::tangent_circle(ball_, light, world_.camera, chords);
    for (core::Vec3& point : points) point = light + light.z / (light.z - point.z) * (point - light);
    return on_screen(points);
  }

private:
  static scene::World make_world() {
    scene::Scene built;
    built.image.width = 64;
    built.image.height = 48;
    built.camera = {{0, -8, 5}, {0, 0, 0.5}, {0, 0, 1}, 40};
    return scene::make_world(built);
  }

  view::ScreenPolygon on_screen(const std::vector<core::Vec3>& points) const {
    const view::Screen screen(world_.camera);
    std::vector<view::ScreenPoint> projected;
    for (const core::Vec3& point : points) {
      const view::ClipPoint p = screen.clip_point(point - world_.camera.eye);
      projected.push_back({32 + 32 * p.right / p.depth, 24 - 24 * p.up / p.depth});
    }
    return view::convex_hull(projected).value();
  }

  scene::World world_ = make_world();
  scene::SphereSurface ball_{{0.3, 0.2, 1.3}, 0.9};
};

/// By which power of the number of chords the error of coverage falls, from a chord a row and less to 64
/// chords a row.
/// Over several shapes: where a frustum's sides touch its chords is chance.
template<typename PolygonOf>
double power_of_error(int shapes, PolygonOf polygon_of) {
  const auto coverages = [&](int chords) {
    scan::Pieces pieces;
    std::vector<double> all;
    double parts = 0;
    for (int which = 0; which < shapes; ++which) {
      const scan::Outline outline(polygon_of(chords, which));
      for (int y = 0; y < 48; ++y) {
        const scan::RowOutline row = outline.in_row(y);
        for (int x = 0; x < 64; ++x) all.push_back(coverage(row, pieces, x, y, parts));
      }
    }
    return all;
  };
  const std::vector<double> exact = coverages(1 << 16);
  const auto error = [&](int chords) {
    const std::vector<double> ours = coverages(chords);
    double sum = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) sum += (ours[i] - exact[i]) * (ours[i] - exact[i]);
    return std::sqrt(sum / static_cast<double>(ours.size()));
  };
  return std::log2(error(32) / error(2048)) / 6;
}

} // namespace

TEST_CASE("the error of coverage by curves falls with the square of their chords") {
  const Curves curves;
  CHECK(power_of_error(1, [&](int chords, int) { return curves.circle(chords); }) > 1.95);
  CHECK(power_of_error(1, [&](int chords, int) { return curves.sphere(chords); }) > 1.95);
  CHECK(power_of_error(6, [&](int chords, int which) { return curves.frustum(chords, which); }) > 1.95);
  CHECK(power_of_error(1, [&](int chords, int) { return curves.shadow_of_sphere(chords); }) > 1.95);
}
