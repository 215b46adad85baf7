#include "setting.h"

#include <halftone/shade/fresnel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace setting;
using halftone::shade::fresnel_reflectance;

namespace {

/// Share of light that passes a plate with reflectance r at both sides and transmittance a inside, all orders
/// of inner reflection: the geometric series (1-r)^2 a / (1 - r^2 a^2).
double through_plate(double r, double a) { return (1 - r) * (1 - r) * a / (1 - r * r * a * a); }

/// How many of 1000 tilted black polygons through the origin are seen from a point on them, by a ray to
/// either side. The points lie about (x, 0).
int polygons_seen_from_themselves(double x) {
  std::mt19937_64 random(34);
  std::uniform_real_distribution<double> component(-1, 1);
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const double a = component(random), b = component(random);
    const auto at = [&](double u, double v) { return Vec3{u, v, a * u + b * v}; };
    const scene::Scene built =
        of({{scene::Polygon{{at(-3, -3), at(3, -3), at(3, 3), at(-3, 3)}}, matte(Color{0})}});
    const Vec3 eye = at(x + component(random) / 2, component(random) / 2);
    if (seen(built, eye, eye + Vec3{0.1, 0.2, 5}) != Color{1}) ++count;
    if (seen(built, eye, eye - Vec3{0.1, 0.2, 5}) != Color{1}) ++count;
  }
  return count;
}

} // namespace

TEST_CASE("a plate of glass passes and reflects what the geometric series says") {
  const double r = fresnel_reflectance(1, 1, 1.5), a = std::exp(-0.6);
  scene::Scene built = of(
      {{scene::Box{{-9, -9, 0}, {9, 9, 2}}, glass(1.5, {0.3, 0.3, 0.3})}, {square_at(-5), matte(Color{1})}});
  built.ambient = Color{1};
  built.background = Color{0};
  CHECK(seen_from_above(built).r == Approx(through_plate(r, a)));
  // A lit ceiling above the eye is seen by reflection: r + (1-r)^2 r a^2 / (1 - r^2 a^2), and the rest on the
  // floor.
  built.objects[1].shape = square_at(50);
  CHECK(seen_from_above(built).r == Approx(r + (1 - r) * (1 - r) * r * a * a / (1 - r * r * a * a)));
}

TEST_CASE(
    "a solid of index 1 is a boundary: it costs a level of depth and has a local term, and bends nothing") {
  scene::Material air = glass(1);
  air.diffuse = {0.25, 0, 0};
  scene::Scene built = of({{scene::Box{{-1, -1, 0}, {1, 1, 1}}, air}});
  built.ambient = Color{1};
  CHECK(seen_from_above(built).r == Approx(1.25));
  CHECK(seen_from_above(built).g == Approx(1));
  built.trace.depth = 3;
  CHECK(seen_from_above(built).g == Approx(1));
  built.trace.depth = 2; // in, but not out
  CHECK(seen_from_above(built) == Color{0.25, 0, 0});
}

TEST_CASE("the medium is the solid that stands last in the file, and hidden boundaries cost nothing") {
  // A ball of water inside a block of glass, listed after it: two boundaries each way. Listed before it:
  // unseen.
  const scene::Box block{{-2, -2, -2}, {2, 2, 2}};
  const scene::Sphere ball{{0, 0, 0}, 1};
  const auto water = glass(1.33, {0, 1, 0}), crown = glass(1.5, {1, 0, 0});
  scene::Scene visible = of({{block, crown}, {ball, water}});
  const double outer = fresnel_reflectance(1, 1, 1.5), inner = fresnel_reflectance(1, 1.5, 1.33);
  const double straight = std::pow(1 - outer, 2) * std::pow(1 - inner, 2);
  visible.trace.cutoff = 0.05; // only what goes straight on
  CHECK(seen_from_above(visible).r == Approx(straight * std::exp(-2)).epsilon(0.01));
  visible.trace.depth = 5;
  CHECK(seen_from_above(visible).b > 0.8);
  visible.trace.depth = 4;
  CHECK(seen_from_above(visible).b < 0.1);

  scene::Scene hidden = of({{ball, water}, {block, crown}});
  hidden.trace.depth = 3;
  hidden.trace.cutoff = 0.05;
  CHECK(seen_from_above(hidden).r == Approx(std::pow(1 - outer, 2) * std::exp(-4)).epsilon(0.01));
  CHECK(seen_from_above(hidden).g == Approx(std::pow(1 - outer, 2)).epsilon(0.01));
}

TEST_CASE("an opaque object is seen in any medium, with absorption on the way") {
  scene::Scene built = of({{scene::Box{{-2, -2, -2}, {2, 2, 2}}, glass(1.5, Color{0.5})},
                           {scene::Sphere{{0, 0, 0}, 1}, matte(Color{1})}});
  built.ambient = Color{1};
  built.background = Color{0};
  const double r = fresnel_reflectance(1, 1, 1.5);
  CHECK(seen_from_above(built).r == Approx((1 - r) * std::exp(-0.5)));
}

TEST_CASE("the eye may be inside glass, nested too") {
  scene::Scene built = of({{scene::Sphere{{0, 0, 0}, 3}, glass(1.5, {1, 0, 0})},
                           {scene::Sphere{{0, 0, 0}, 1}, glass(1.2, {0, 1, 0})}});
  built.trace.cutoff = 0.0;
  built.trace.depth = 3;
  const Color color = seen(built, {0, 0, 0}, {0, 1, 0});
  const double inner = fresnel_reflectance(1, 1.2, 1.5), outer = fresnel_reflectance(1, 1.5, 1);
  // Straight out, to depth 3: background times both transmittances; what is reflected stays deeper than 3.
  CHECK(color.r == Approx((1 - inner) * (1 - outer) * std::exp(-2)));
  CHECK(color.g == Approx((1 - inner) * (1 - outer) * std::exp(-1)));
}

TEST_CASE("an eye exactly on a surface counts as outside, and meets the surface at distance zero") {
  scene::Scene built = of({{scene::Box{{-2, -2, -3}, {2, 2, 0}}, glass(1.5, {1, 1, 1})}});
  built.trace.depth = 3;
  const double r = fresnel_reflectance(1, 1, 1.5);
  CHECK(seen(built, {0, 0, 0}, {0, 0, -1}).r == Approx(r + (1 - r) * (1 - r) * std::exp(-3)).epsilon(1e-3));
  CHECK(seen(built, {0, 0, 0}, {0.3, 0.4, 1}) == Color{1});
  // The same on a polygon: it is not seen from within its own plane, nor from a point on it.
  const scene::Scene floor = of({{square_at(0), matte(Color{0})}});
  CHECK(seen(floor, {0.3, 0.4, 0}, {1, 1, -1}) == Color{1});
  CHECK(seen(floor, {0.3, 0.4, 0}, {1, 1, 1}) == Color{1});
}

TEST_CASE("an eye on a surface sees nothing of it on the way out, whatever rounding says") {
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> component(-1, 1);
  for (const bool is_glass : {true, false}) {
    scene::Scene built = of({{scene::Sphere{{0.1, 0.2, 0.3}, 0.7}, is_glass ? glass(1.5) : matte(Color{0})}});
    built.materials[0].diffuse = Color{0.5};
    for (int i = 0; i < 200; ++i) {
      const Vec3 out = glm::normalize(Vec3{component(random), component(random), component(random)});
      const Vec3 eye = Vec3{0.1, 0.2, 0.3} + out * 0.7;
      const Vec3 along = out + Vec3{component(random), component(random), component(random)} * 0.5;
      INFO("seed 33, eye " << i << " at " << eye.x << ' ' << eye.y << ' ' << eye.z);
      CHECK(seen(built, eye, eye + along) == Color{1});
    }
  }
}

TEST_CASE("a polygon is not seen from a point on it, whatever rounding says") {
  CHECK(polygons_seen_from_themselves(2) == 0);
}

TEST_CASE("a polygon is not seen from a point on it that is nearer to the origin than its corners") {
  CHECK(polygons_seen_from_themselves(0) == 0);
}

TEST_CASE("a glass surface has a local term from outside only") {
  scene::Material tinted = glass(1.5);
  tinted.diffuse = Color{1};
  scene::Scene built = of({{scene::Box{{-2, -2, -3}, {2, 2, 3}}, tinted}});
  built.ambient = Color{0.25};
  built.background = Color{0};
  CHECK(seen_from_above(built).r == Approx(0.25));
  CHECK(seen(built, {0, 0, 0}, {0, 0, 1}) == Color{0});
}
