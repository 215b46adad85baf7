#include "support/coinciding_cones.h"

#include "cut.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

using namespace halftone::reference;
namespace scene = halftone::scene;

namespace {

std::vector<scene::Shape> one_of_each() {
  return {scene::Sphere{{1, 2, 3}, 2},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 1.5, 1.5},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 1.5, 0},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 0, 1.5},
          scene::Frustum{{0, 0, -1}, {1, 0, 2}, 0.5, 2},
          scene::Frustum{{0, 0, 0}, {0.1, 0, 0}, 3, 1},
          scene::Box{{-1, -2, -0.5}, {2, 1, 0.25}},
          scene::Prism{{0, 0, -1}, {0, 1, 2}, 1.25, 7, 11}};
}

World world_of(const scene::Shape& shape) {
  scene::Scene built;
  built.camera.target = {1, 0, 0};
  built.materials.push_back({});
  scene::Object object;
  object.shape = shape;
  built.objects.push_back(object);
  return scene::make_world(built);
}

} // namespace

TEST_CASE("a line is inside a solid exactly between the ends of its span") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal;
  const auto shapes = one_of_each();
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const World world = world_of(shapes[s]);
    int hits = 0;
    for (int i = 0; i < 4'000; ++i) {
      const Vec3 aim = Vec3{uniform(random), uniform(random), uniform(random)} * 3.0;
      const Vec3 direction = glm::normalize(Vec3{normal(random), normal(random), normal(random)});
      const Line line{aim - direction * (10 * uniform(random)), direction, -1, false};
      const auto span = cut(world, world.bodies[0], line);
      INFO("seed 7, shape " << s << ", line " << i);
      for (int k = 0; k < 40; ++k) {
        const double t = 20 * uniform(random);
        const bool inside = span && t > span->in.t && t < span->out.t;
        // Within 1e-12 of an end, rounding of the point decides what contains() says.
        if (span && (std::abs(t - span->in.t) < 1e-12 || std::abs(t - span->out.t) < 1e-12)) continue;
        REQUIRE(contains(world, world.bodies[0], line.at(t)) == inside);
      }
      if (!span) continue;
      ++hits;
      for (const Crossing& end : {span->in, span->out}) {
        const scene::Face& face = world.bodies[0].faces[end.face];
        const Height height = height_over(world, world.surfaces[face.surface], line.at(end.t));
        REQUIRE(std::abs(height.value) < 1e-12);
      }
    }
    CHECK(hits > 300);
  }
}

TEST_CASE("a line that starts on a face and leaves the solid never meets it again") {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  const auto shapes = one_of_each();
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const World world = world_of(shapes[s]);
    const Body& body = world.bodies[0];
    int tried = 0;
    for (int i = 0; i < 6'000; ++i) {
      const Vec3 center = (body.bounds[0] + body.bounds[1]) / 2.0;
      const Vec3 direction = glm::normalize(Vec3{normal(random), normal(random), normal(random)});
      const auto span = cut(world, body, {center - direction * 30.0, direction, -1, false});
      if (!span) continue;
      const Vec3 point = center - direction * 30.0 + direction * span->in.t;
      const scene::Face& face = body.faces[span->in.face];
      const Vec3 surface_normal = scene::normal_at(world.surfaces[face.surface], point);
      const Vec3 outward = face.flipped ? -surface_normal : surface_normal;
      Vec3 away = glm::normalize(Vec3{normal(random), normal(random), normal(random)});
      // Half of the rays graze the surface within 1e-9.
      if (i % 2) away = glm::normalize(away - outward * (glm::dot(away, outward) * (1 - 1e-9)));
      if (glm::dot(away, outward) < 0) away = -away;
      INFO("seed 8, shape " << s << ", line " << i);
      Line line{point, away, face.surface, !face.flipped};
      const auto left = cut(world, body, line);
      REQUIRE((!left || left->out.t <= 0));
      line.direction = -away;
      line.outward = face.flipped;
      const Crossing out = exit(world, body, line);
      REQUIRE(out.t >= 0);
      REQUIRE(std::isfinite(out.t));
      ++tried;
    }
    CHECK(tried > 3'000);
  }
}

TEST_CASE("every line has two ends in a solid where its faces have been given those of others") {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const World world = halftone::test::coinciding_cones(random);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 direction{uniform(random), uniform(random),
                         uniform(random) * std::exp2(-16 * std::abs(uniform(random)))};
    const Line line{{uniform(random), uniform(random), uniform(random)}, glm::normalize(direction)};
    for (const Body& body : world.bodies) {
      INFO("seed 6, line " << i);
      const auto span = cut(world, body, line);
      if (span) REQUIRE((span->in.face >= 0 && span->out.face >= 0));
      REQUIRE(std::isfinite(exit(world, body, line).t));
    }
  }
}

TEST_CASE("coinciding faces are met at the same distance, to the bit") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> angle(-180, 180), uniform(-1, 1);
  int met = 0;
  for (int round = 0; round < 300; ++round) {
    scene::Scene built;
    built.camera.target = {1, 0, 0};
    built.materials.push_back({});
    for (const scene::Shape& shape : {scene::Shape{scene::Prism{{0, 0, 0}, {0, 0, 1}, 2, 8, 22.5}},
                                      scene::Shape{scene::Frustum{{0, 0, 1}, {0, 0, 3}, 0.7, 0.7}},
                                      scene::Shape{scene::Frustum{{0, 0, 1.5}, {0, 0, 2.5}, 0.7, 0.7}}}) {
      scene::Object object;
      object.shape = shape;
      object.placement = {1.3, {angle(random), angle(random), angle(random)}, {7, 8, 9}};
      if (!built.objects.empty()) object.placement = built.objects[0].placement;
      built.objects.push_back(object);
    }
    const World world = scene::make_world(built);
    for (int i = 0; i < 50; ++i) {
      const Vec3 aim = (world.bodies[1].bounds[0] + world.bodies[1].bounds[1]) / 2.0 +
                       Vec3{uniform(random), uniform(random), uniform(random)} * 0.3;
      const Vec3 direction = glm::normalize(Vec3{uniform(random), uniform(random), uniform(random)});
      const Line line{aim - direction * 20.0, direction, -1, false};
      std::array<std::optional<Span>, 3> spans;
      for (int b = 0; b < 3; ++b) spans[b] = cut(world, world.bodies[b], line);
      INFO("seed 9, round " << round << ", line " << i);
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          if (a == b || !spans[a] || !spans[b]) continue;
          const auto surface = [&](int body, const Crossing& c) {
            return world.bodies[body].faces[c.face].surface;
          };
          for (const Crossing& x : {spans[a]->in, spans[a]->out})
            for (const Crossing& y : {spans[b]->in, spans[b]->out}) {
              if (surface(a, x) != surface(b, y) || std::abs(x.t - y.t) > 0.1) continue;
              REQUIRE(x.t == y.t);
              ++met;
            }
        }
    }
  }
  CHECK(met > 1'000);
}
