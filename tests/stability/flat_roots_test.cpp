#include "root_tally.h"
#include "support/random_scene.h"

#include <catch2/catch.hpp>

// Where lines enter and leave convex polyhedra and meet polygons, against exact arithmetic: at corners and
// edges, along them, in the planes of faces, from inside and from 10^8 sizes away, at scales from 2^-190 to
// 2^190.

using namespace halftone;
using core::Vec3;

namespace {

const char* const kind_names[] = {"anywhere",      "at a corner",   "at an edge",
                                  "along an edge", "along a plane", "inside"};

enum class Flat { box, prism, polyhedron, polygon };

Vec3 random_vector(test::RandomScene& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// Often nothing, else of any order of magnitude down to rounding.
double little(test::RandomScene& random) {
  const int sign = random.pick(3) - 1;
  return sign * std::exp2(random.uniform(-60, -20));
}

/// A tetrahedron or a skew box, up to a thousand times as long as it is wide.
scene::Polyhedron random_polyhedron(test::RandomScene& random, const Vec3& at, double scale) {
  Vec3 sides[3];
  for (Vec3& side : sides)
    side = scale * std::exp2(random.uniform(-5, 5)) * glm::normalize(random_vector(random));
  if (random.pick(2) == 0)
    return {{at, at + sides[0], at + sides[1], at + sides[2]}, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}};
  scene::Polyhedron skew;
  for (int k = 0; k < 8; ++k)
    skew.vertices.push_back(at + (k & 1 ? sides[0] : Vec3{0}) + (k & 2 ? sides[1] : Vec3{0}) +
                            (k & 4 ? sides[2] : Vec3{0}));
  skew.faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  return skew;
}

/// Corners on an ellipse.
scene::Polygon random_polygon(test::RandomScene& random, const Vec3& at, double scale) {
  const Vec3 normal = glm::normalize(random_vector(random));
  const Vec3 u = glm::normalize(glm::cross(normal, random_vector(random))), v = glm::cross(normal, u);
  const double a = scale * std::exp2(random.uniform(-5, 5)), b = scale * std::exp2(random.uniform(-5, 5));
  const int corners = 3 + random.pick(6);
  scene::Polygon polygon;
  for (int k = 0; k < corners; ++k) {
    const double phi = 6.28 / corners * (k + random.uniform(0, 0.8));
    polygon.vertices.push_back(at + u * (a * std::cos(phi)) + v * (b * std::sin(phi)));
  }
  return polygon;
}

scene::Shape random_shape(test::RandomScene& random, Flat shape, double scale) {
  const Vec3 at = 5.0 * scale * random_vector(random);
  const auto size = [&] { return scale * std::exp2(random.uniform(-10, 10)); };
  switch (shape) {
  case Flat::box:
    return scene::Box{at, at + Vec3{size(), size(), size()}};
  case Flat::prism:
    return scene::Prism{at, at + size() * glm::normalize(random_vector(random)), size(), 3 + random.pick(6),
                        random.uniform(0, 90)};
  case Flat::polyhedron:
    return random_polyhedron(random, at, scale);
  default:
    return random_polygon(random, at, scale);
  }
}

/// A line of some kind at a body. sizes: how far off its origin is at most, as a power of ten.
test::Thrown thrown_at(const scene::World& world, test::RandomScene& random) {
  const scene::Body& body = world.bodies[0];
  const double size = glm::length(body.bounds[1] - body.bounds[0]) / 2;
  const scene::Face& face = body.faces[random.pick(static_cast<int>(body.faces.size()))];
  const auto& plane = std::get<scene::Plane>(world.surfaces[face.surface]);
  const int corners = static_cast<int>(face.outline.size()), k = random.pick(corners);
  const Vec3 corner = face.outline[k], edge = face.outline[(k + 1) % corners] - corner;
  const Vec3 middle = (body.bounds[0] + body.bounds[1]) / 2.0;
  const Vec3 on_edge = corner + edge * random.uniform(0, 1);
  const Vec3 off = random_vector(random) * (size * little(random));
  const int kind = random.pick(6);
  Vec3 target = middle + random_vector(random) * (body.bounds[1] - body.bounds[0]) * 0.55;
  Vec3 direction = random_vector(random);
  double far = size * std::pow(10, random.uniform(-1, 8));
  if (kind == 1) target = corner + off;
  if (kind == 2) target = on_edge + off;
  if (kind == 3) target = on_edge + off, direction = glm::normalize(edge) + direction * little(random);
  if (kind == 4) {
    target = on_edge + random.uniform(-0.1, 1) * (middle - on_edge);
    target += plane.normal * (plane.offset - glm::dot(plane.normal, target)) + off;
    direction = glm::normalize(glm::cross(plane.normal, direction)) + plane.normal * little(random);
  }
  if (kind == 5) target = on_edge + random.uniform(0, 1) * (middle - on_edge), far = 0;
  direction = glm::normalize(direction) * (random.pick(2) == 0 ? 1.0 : -1.0);
  test::Thrown thrown{{target - direction * far, direction, -1, false}, kind_names[kind]};
  thrown.unit = test::unit_of(body, thrown.line.origin);
  return thrown;
}

template<typename Real>
test::RootError error_of(const test::ExactFlat<Real>& exact, const geometry::Solids& solids,
                         const test::Thrown& thrown) {
  return test::error_of_span<Real>(exact, solids.span(0, thrown.line), thrown);
}

/// Whether a polygon is met is judged by how far the line passes from its nearest edge, or starts from its
/// plane.
template<typename Real>
test::RootError error_of(const test::ExactPolygon<Real>& exact, const geometry::Solids& solids,
                         const test::Thrown& thrown) {
  const test::ExactLine<Real> line(thrown.line);
  const auto height = [&](double t) {
    return std::abs(static_cast<double>(exact.height_over(line.at(t)))) / thrown.unit;
  };
  const auto ours = solids.crossing(0, thrown.line);
  const auto t = exact.crossing(line);
  const auto [passes, beside] = exact.passes(line);
  if (ours.has_value() != (passes && t && *t > 0))
    return {true, std::min(static_cast<double>(beside) / thrown.unit, height(0))};
  return {false, ours ? height(ours->t) : 0};
}

template<template<typename> typename Exact>
void throw_lines(Flat shape, std::uint64_t seed, int lines, test::RootTally& tally) {
  test::RandomScene random(seed);
  const double scale = std::ldexp(1.0, random.pick(2) == 0 ? 0 : random.pick(381) - 190);
  scene::Scene built;
  built.materials.resize(1);
  built.objects.resize(1);
  built.objects[0].shape = random_shape(random, shape, scale);
  built.objects[0].placement.rotate = {random.uniform(-90, 90), random.uniform(-90, 90), 0};
  const scene::World world = scene::make_world(built);
  const geometry::Solids solids(world);
  const Exact<test::Twofold> exact(world);
  const Exact<test::Quad> quad(world);
  for (int number = 0; number < lines; ++number) {
    test::Thrown thrown = thrown_at(world, random);
    thrown.seed = seed;
    thrown.number = number;
    const auto error = error_of(exact, solids, thrown);
    test::add(tally, error, thrown);
    if (number % 64 != 0) continue;
    const double differs = std::abs(error_of(quad, solids, thrown).roundings - error.roundings);
    tally.oracle.add(differs, !(differs <= test::most_of_oracle), thrown);
  }
}

void check_roots(std::uint64_t seeds, int lines, bool is_long) {
  const std::pair<Flat, const char*> shapes[] = {{Flat::box, "box"},
                                                 {Flat::prism, "prism"},
                                                 {Flat::polyhedron, "polyhedron"},
                                                 {Flat::polygon, "polygon"}};
  for (const auto& [shape, name] : shapes) {
    const auto each = shape == Flat::polygon ? throw_lines<test::ExactPolygon> : throw_lines<test::ExactFlat>;
    test::check_roots_of(name, {seeds, lines, is_long}, [&, wanted = shape](std::uint64_t seed, auto& sums) {
      each(wanted, seed, lines, sums);
    });
  }
}

} // namespace

TEST_CASE("lines meet flat solids and polygons where exact arithmetic says") { check_roots(200, 250, false); }

TEST_CASE("lines meet flat solids where exact arithmetic says: many", "[.][long]") {
  check_roots(400'000, 250, true);
}
