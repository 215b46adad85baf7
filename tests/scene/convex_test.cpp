#include "convex.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

using halftone::core::Mat3;
using halftone::core::Vec3;
namespace scene = halftone::scene;
using scene::Loop;
using scene::PolygonFlaw;
using scene::Polyhedron;
using scene::PolyhedronFlaw;

namespace {

Loop all_of(const std::vector<Vec3>& vertices) {
  Loop loop(vertices.size());
  std::iota(loop.begin(), loop.end(), 0);
  return loop;
}

std::optional<PolygonFlaw> flaw_of(const std::vector<Vec3>& vertices) {
  return scene::flaw_of(vertices, all_of(vertices));
}

/// The kind of a flaw that must be there.
PolygonFlaw::Kind polygon_kind(const std::vector<Vec3>& vertices) {
  const auto flaw = flaw_of(vertices);
  REQUIRE(flaw);
  return flaw->kind;
}

PolyhedronFlaw::Kind polyhedron_kind(const Polyhedron& polyhedron) {
  const auto flaw = scene::flaw_of(scene::welded(polyhedron));
  REQUIRE(flaw);
  return flaw->kind;
}

bool is_flawless(const Polyhedron& polyhedron) { return !scene::flaw_of(scene::welded(polyhedron)); }

/// A regular polygon of radius 1 in the plane z = 0.
std::vector<Vec3> ring(int corners) {
  std::vector<Vec3> vertices;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return vertices;
}

struct Random {
  std::mt19937 bits;
  explicit Random(unsigned seed) : bits(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits); }

  Vec3 direction() {
    for (;;) {
      const Vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (const double length = glm::length(v); length > 0.1 && length < 1) return v / length;
    }
  }

  Mat3 rotation() {
    const Vec3 x = direction();
    const Vec3 y = glm::normalize(glm::cross(x, direction()));
    return Mat3(x, y, glm::cross(x, y));
  }
};

/// The points turned at random and moved by a distance in a random direction, with the given number of
/// decimals, as an author's file has them.
std::vector<Vec3> placed(const std::vector<Vec3>& points, Random& random, double distance, double decimals) {
  const Mat3 rotation = random.rotation();
  const Vec3 offset = distance * random.direction();
  const double unit = std::pow(10.0, decimals);
  std::vector<Vec3> moved;
  for (const Vec3& p : points) moved.push_back(glm::round((rotation * p + offset) * unit) / unit);
  return moved;
}

const Polyhedron cube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
    {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

const Polyhedron icosahedron = [] {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return Polyhedron{{{-1, g, 0},
                     {1, g, 0},
                     {-1, -g, 0},
                     {1, -g, 0},
                     {0, -1, g},
                     {0, 1, g},
                     {0, -1, -g},
                     {0, 1, -g},
                     {g, 0, -1},
                     {g, 0, 1},
                     {-g, 0, -1},
                     {-g, 0, 1}},
                    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}();

/// Each face as a fan of triangles: neighbours in one plane.
Polyhedron triangulated(const Polyhedron& polyhedron) {
  Polyhedron triangles{polyhedron.vertices, {}};
  for (const Loop& face : polyhedron.faces)
    for (std::size_t i = 2; i < face.size(); ++i) triangles.faces.push_back({face[0], face[i - 1], face[i]});
  return triangles;
}

} // namespace

TEST_CASE("regular polygons anywhere are convex, with their corners rounded to six decimals or not") {
  Random random(1);
  for (int corners = 3; corners <= 60; ++corners)
    for (const double decimals : {6.0, 15.0}) {
      const auto vertices = placed(ring(corners), random, 10, decimals);
      INFO("seed 1, " << corners << " corners, " << decimals << " decimals");
      // Six decimals put a corner up to 1e-6 off its place: the tolerance, where the edges are 1 or longer.
      if (decimals > 6 || corners <= 6) CHECK_FALSE(flaw_of(vertices));
    }
}

TEST_CASE("of all orders of five corners, only those around the polygon are accepted") {
  Random random(2);
  const auto corners = placed(ring(5), random, 4, 12);
  Loop loop{0, 1, 2, 3, 4};
  int accepted = 0;
  do {
    const bool around = std::all_of(loop.begin(), loop.end(), [&](int& k) {
      const int step = (loop[(&k - loop.data() + 1) % 5] - k + 5) % 5;
      return step == (loop[1] - loop[0] + 5) % 5 && (step == 1 || step == 4);
    });
    INFO(loop[0] << loop[1] << loop[2] << loop[3] << loop[4]);
    CHECK(scene::flaw_of(corners, loop).has_value() == !around);
    accepted += around ? 1 : 0;
  } while (std::next_permutation(loop.begin(), loop.end()));
  CHECK(accepted == 10);
}

TEST_CASE("a star and a square walked twice wind more than once around") {
  const auto corners = ring(5);
  const auto star = scene::flaw_of(corners, {0, 2, 4, 1, 3});
  REQUIRE(star);
  CHECK(star->kind == PolygonFlaw::winds_further);
  CHECK(polygon_kind(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) ==
        PolygonFlaw::winds_further);
}

TEST_CASE("a vertex may be a millionth of the longest edge off the plane, and is projected onto it") {
  // A square with one corner raised by h has all four corners h / 4 off its Newell plane.
  const std::vector<Vec3> near{{0, 0, 0}, {1, 0, 0}, {1, 1, 3.9e-6}, {0, 1, 0}};
  const std::vector<Vec3> far{{0, 0, 0}, {1, 0, 0}, {1, 1, 4.1e-6}, {0, 1, 0}};
  CHECK_FALSE(flaw_of(near));
  CHECK(polygon_kind(far) == PolygonFlaw::not_planar);

  const std::vector<Vec3> flat = scene::flattened(near, all_of(near));
  const scene::LoopPlane plane = scene::plane_of(near, all_of(near));
  for (std::size_t i = 0; i < flat.size(); ++i) {
    CHECK(std::abs(plane.height(flat[i])) < 1e-16);
    CHECK(glm::distance(flat[i], near[i]) < 1e-6);
  }
}

TEST_CASE("a planar polygon's vertices keep their bits, so that neighbours share them") {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const double distance = random.between(0, 1e4);
    const auto vertices = placed(ring(3 + trial % 9), random, distance, 17);
    INFO("seed 3, trial " << trial);
    REQUIRE_FALSE(flaw_of(vertices));
    CHECK(scene::flattened(vertices, all_of(vertices)) == vertices);
  }
}

TEST_CASE("a vertex on an edge is no dent, one pushed in by more than a millionth is") {
  const auto with_middle_at = [](double y) {
    return std::vector<Vec3>{{0, 0, 0}, {0.5, y, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  };
  CHECK_FALSE(flaw_of(with_middle_at(0)));
  CHECK_FALSE(flaw_of(with_middle_at(-0.1)));
  CHECK_FALSE(flaw_of(with_middle_at(0.9e-6)));
  CHECK(polygon_kind(with_middle_at(1.1e-6)) == PolygonFlaw::not_convex);
  CHECK(polygon_kind(with_middle_at(0.4)) == PolygonFlaw::not_convex);
}

TEST_CASE("thin polygons have an area, and zigzags within a thin strip are not convex") {
  CHECK_FALSE(flaw_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}));
  CHECK(polygon_kind({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-17, 0}}) == PolygonFlaw::on_a_line);
  CHECK(polygon_kind({{0, 0, 0}, {1, 0, 0}, {0.3, 1e-8, 0}, {0.6, 2e-8, 0}, {0, 3e-8, 0}}) ==
        PolygonFlaw::not_convex);
}

TEST_CASE("repeated vertices count once") {
  const std::vector<Vec3> vertices{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {-0.0, 0, 0}};
  CHECK(scene::without_repeats(vertices, all_of(vertices)) == Loop{0, 2, 3});
  CHECK(polygon_kind({{0, 0, 0}, {1, 0, 0}}) == PolygonFlaw::few_vertices);
  CHECK(polygon_kind({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}}) == PolygonFlaw::few_vertices);
  CHECK(polygon_kind({}) == PolygonFlaw::few_vertices);
  CHECK(polygon_kind({{0, 0, 0}, {1e-90, 0, 0}, {0, 1e-90, 0}}) == PolygonFlaw::few_vertices);
}

TEST_CASE("scaling by a power of two changes no decision about a polygon and no bit of it") {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    auto vertices = placed(ring(4 + trial % 5), random, 1, 15);
    // Around the tolerance, to both sides of it.
    for (const int k : {1, 2}) {
      const double distance = random.between(0, 3e-6);
      vertices[k] += distance * random.direction();
    }
    const auto flaw = flaw_of(vertices);
    for (const int exponent : {-150, -40, -1, 3, 40, 150}) {
      auto scaled = vertices;
      for (Vec3& v : scaled) v *= std::ldexp(1.0, exponent);
      const auto scaled_flaw = flaw_of(scaled);
      INFO("seed 4, trial " << trial << ", exponent " << exponent);
      REQUIRE(flaw.has_value() == scaled_flaw.has_value());
      if (flaw) CHECK((flaw->kind == scaled_flaw->kind && flaw->vertex == scaled_flaw->vertex));
      auto flat = scene::flattened(vertices, all_of(vertices));
      for (Vec3& v : flat) v *= std::ldexp(1.0, exponent);
      CHECK(scene::flattened(scaled, all_of(scaled)) == flat);
    }
  }
}

TEST_CASE("closed convex polyhedra are accepted anywhere, triangulated or not, loops either way round") {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial)
    for (const Polyhedron& solid : {cube, triangulated(cube), icosahedron}) {
      Polyhedron moved{placed(solid.vertices, random, 5, 15), solid.faces};
      for (Loop& face : moved.faces)
        if (random.between(0, 1) < 0.5) std::reverse(face.begin(), face.end());
      INFO("seed 5, trial " << trial << ", " << solid.faces.size() << " faces");
      CHECK(is_flawless(moved));
    }
}

TEST_CASE("faces may have vertices of their own, at the same places") {
  Polyhedron separate;
  for (const Loop& face : cube.faces) {
    separate.faces.emplace_back();
    for (const int k : face) {
      separate.faces.back().push_back(static_cast<int>(separate.vertices.size()));
      separate.vertices.push_back(cube.vertices[k]);
    }
  }
  CHECK(is_flawless(separate));
  CHECK(scene::welded(separate).faces[0] == Loop{0, 1, 2, 3});
}

TEST_CASE("a polyhedron without one of its faces is open, with one of them twice it is crowded") {
  for (const Polyhedron& solid : {cube, icosahedron})
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
      Polyhedron open = solid;
      open.faces.erase(open.faces.begin() + static_cast<std::ptrdiff_t>(f));
      Polyhedron twice = solid;
      twice.faces.push_back(solid.faces[f]);
      INFO(solid.faces.size() << " faces, face " << f);
      CHECK(polyhedron_kind(open) == PolyhedronFlaw::open);
      CHECK(polyhedron_kind(twice) == PolyhedronFlaw::crowded_edge);
    }
}

TEST_CASE("a polyhedron with a vertex pushed in is not convex, unless by less than a millionth") {
  for (std::size_t k = 0; k < icosahedron.vertices.size(); ++k) {
    Polyhedron dented = icosahedron, scratched = triangulated(cube);
    dented.vertices[k] *= 0.4;
    INFO("vertex " << k);
    CHECK(polyhedron_kind(dented) == PolyhedronFlaw::not_convex);
    if (k >= scratched.vertices.size()) continue;
    scratched.vertices[k] *= 1 + 0.5e-6;
    CHECK(is_flawless(scratched));
  }
}

TEST_CASE("a vertex in the middle of a face makes no edge of its own, and a flat polyhedron has no inside") {
  Polyhedron with_extra = cube;
  with_extra.vertices.emplace_back(0.5, 0.5, 1.0);
  CHECK(polyhedron_kind(with_extra) == PolyhedronFlaw::unused_vertex);
  CHECK(polyhedron_kind({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}},
                         {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}) == PolyhedronFlaw::flat);
}

TEST_CASE("a plate a millionth as thick as it is wide is a polyhedron") {
  Polyhedron plate = cube;
  for (Vec3& v : plate.vertices) v.z *= 1e-6;
  CHECK(is_flawless(plate));
  for (Vec3& v : plate.vertices) v.z *= 1e-3;
  CHECK(is_flawless(plate));
}
