#include "support/coinciding_cones.h"

#include "shapes.h"

#include <halftone/geometry/solids.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

using namespace shapes;
using halftone::geometry::Crossing;
using halftone::geometry::Line;
using halftone::geometry::Solids;
using halftone::geometry::Span;

namespace {

// How far a point is inside a shape, by the shape's own numbers; negative outside. Only the sign is exact in
// meaning.

double depth_in(const scene::Sphere& sphere, const Vec3& p) {
  return sphere.radius - glm::length(p - sphere.center);
}

double depth_in(const scene::Frustum& frustum, const Vec3& p) {
  const Vec3 axis = frustum.top - frustum.base;
  const double share = glm::dot(p - frustum.base, axis) / glm::dot(axis, axis);
  const double radius = frustum.base_radius + (frustum.top_radius - frustum.base_radius) * share;
  return std::min({share, 1 - share, radius - glm::length(p - frustum.base - axis * share)});
}

double depth_in(const scene::Box& box, const Vec3& p) {
  const Vec3 depth = glm::min(p - box.min, box.max - p);
  return std::min({depth.x, depth.y, depth.z});
}

double depth_in(const scene::Prism& prism, const Vec3& p) {
  const Vec3 axis = glm::normalize(prism.top - prism.base);
  const Vec3 u = glm::normalize(Vec3{1, 0, 0} - axis * axis.x); // the axes used here are not near x
  const Vec3 v = glm::cross(axis, u);
  const double height = glm::dot(p - prism.base, axis);
  double depth = std::min(height, glm::length(prism.top - prism.base) - height);
  for (int k = 0; k < prism.sides; ++k) {
    const double phi = (prism.turn + 360.0 * (k + 0.5) / prism.sides) * (std::numbers::pi / 180);
    const double out = glm::dot(p - prism.base, u * std::cos(phi) + v * std::sin(phi));
    depth = std::min(depth, prism.radius * std::cos(std::numbers::pi / prism.sides) - out);
  }
  return depth;
}

double depth_in(const scene::Polyhedron&, const Vec3&) { return 0; } // none here
double depth_in(const scene::Polygon&, const Vec3&) { return 0; }

double depth_in(const scene::Shape& shape, const Vec3& p) {
  return std::visit([&](const auto& s) { return depth_in(s, p); }, shape);
}

/// Whether the span says of every point ahead what the shape says. Rounding decides within 1e-11.
bool agrees_with_membership(const scene::Shape& shape, const Line& line, const std::optional<Span>& span,
                            std::mt19937_64& random) {
  std::uniform_real_distribution<double> ahead(0, 25);
  for (int k = 0; k < 40; ++k) {
    const double t = ahead(random);
    const double depth = depth_in(shape, line.at(t));
    const bool inside = span && t > span->in.t && t < span->out.t;
    if (std::abs(depth) > 1e-11 && (depth > 0) != inside) return false;
  }
  return true;
}

std::string text(const Line& line) {
  std::ostringstream out;
  out.precision(17);
  out << "line from " << line.origin.x << ", " << line.origin.y << ", " << line.origin.z << " along "
      << line.direction.x << ", " << line.direction.y << ", " << line.direction.z;
  return out.str();
}

/// Distance of a point from the surface of a face.
double off_surface(const scene::World& world, const scene::Face& face, const Vec3& p) {
  const scene::Surface& surface = world.surfaces[face.surface];
  if (const auto* plane = std::get_if<scene::Plane>(&surface))
    return glm::dot(plane->normal, p) - plane->offset;
  if (const auto* sphere = std::get_if<scene::SphereSurface>(&surface))
    return glm::length(p - sphere->center) - sphere->radius;
  const auto& cone = std::get<scene::ConeSurface>(surface);
  const double along = glm::dot(p - cone.origin, cone.axis);
  return glm::length(p - cone.origin - cone.axis * along) - (cone.radius + cone.slope * along);
}

} // namespace

TEST_CASE("a line is inside a solid exactly between the ends of its span") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> back(-10, 10);
  const auto all = one_of_each();
  for (std::size_t s = 0; s < all.size(); ++s) {
    const scene::World world = world_of({all[s]});
    const Solids solids(world);
    int hits = 0;
    for (int i = 0; i < 4'000; ++i) {
      const Vec3 direction = random_direction(random);
      const Line line{random_point(random, 3) - direction * back(random), direction};
      const auto span = solids.span(0, line);
      INFO("seed 7, shape " << s << ", line " << i << ": " << text(line));
      REQUIRE(agrees_with_membership(all[s], line, span, random));
      if (!span) continue;
      ++hits;
      REQUIRE(span->in.t < span->out.t);
      REQUIRE(span->out.t > 0);
      for (const Crossing& end : {span->in, span->out})
        REQUIRE(std::abs(off_surface(world, world.bodies[0].faces[end.face], line.at(end.t))) < 1e-12);
    }
    CHECK(hits > 250);
  }
}

TEST_CASE("lines along axes, generators and through the apex of a cone are cut like all others") {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::vector<scene::Shape> all{
      scene::Frustum{{0, 0, 0}, {0, 0, 2}, 1, 1}, scene::Frustum{{0, 0, 0}, {0, 0, 1}, 1, 0},
      scene::Frustum{{0, 0, 0}, {0, 0, 1}, 0, 1}, scene::Frustum{{0, 0, 0}, {0, 0, 1}, 2, 1},
      scene::Box{{-1, -1, 0}, {1, 1, 1}}};
  const Vec3 tip{0, 0, 1}, generator = glm::normalize(Vec3{1, 0, -1});
  for (std::size_t s = 0; s < all.size(); ++s) {
    const Solids solids(world_of({all[s]}));
    for (int i = 0; i < 500; ++i) {
      const double a = uniform(random), b = uniform(random), c = uniform(random);
      const Vec3 any = random_direction(random);
      for (const Line& line :
           {Line{{a, b, 9}, {0, 0, -1}}, Line{{a, b, -9}, {-0.0, -0.0, 1}}, Line{{0, 0, 9}, {0, 0, -1}},
            Line{{9, a, 0.5}, {-1, -0.0, -0.0}}, Line{{a, -9, c}, {0, 1, 0}}, Line{tip - any * 9.0, any},
            Line{Vec3{0, 0, 0} - any * 9.0, any}, Line{Vec3{a, 0, c} - generator * 9.0, generator},
            Line{Vec3{a, b, c} + generator * 9.0, -generator},
            Line{Vec3{0.5, 0, 0.5} - generator * 9.0, generator}}) {
        INFO("seed 17, shape " << s << ", case " << i << ": " << text(line));
        const auto span = solids.span(0, line);
        REQUIRE(agrees_with_membership(all[s], line, span, random));
        if (span) REQUIRE((span->in.face >= 0 && span->out.face >= 0));
      }
    }
  }
}

TEST_CASE("a line that starts on a face and leaves the solid never meets it again") {
  std::mt19937_64 random(8);
  const auto all = one_of_each();
  for (std::size_t s = 0; s < all.size(); ++s) {
    const scene::World world = world_of({all[s]});
    const scene::Body& body = world.bodies[0];
    const Solids solids(world);
    int tried = 0;
    for (int i = 0; i < 6'000; ++i) {
      const Vec3 center = (body.bounds[0] + body.bounds[1]) / 2.0;
      const Vec3 towards = random_direction(random);
      const Line arriving{center + random_point(random, 1) - towards * 30.0, towards};
      const auto span = solids.span(0, arriving);
      if (!span) continue;
      const Vec3 point = arriving.at(span->in.t);
      const scene::Face& face = body.faces[span->in.face];
      const Vec3 normal = scene::normal_at(world.surfaces[face.surface], point);
      const Vec3 outward = face.flipped ? -normal : normal;
      Vec3 away = random_direction(random);
      // Half of the rays graze the surface within 1e-9.
      if (i % 2) away = glm::normalize(away - outward * (glm::dot(away, outward) * (1 - 1e-9)));
      if (glm::dot(away, outward) < 0) away = -away;
      INFO("seed 8, shape " << s << ", line " << i);
      REQUIRE_FALSE(solids.span(0, {point, away, face.surface, !face.flipped}));
      const Crossing out = solids.exit(0, {point, -away, face.surface, face.flipped});
      REQUIRE(out.t >= 0);
      REQUIRE(std::isfinite(out.t));
      REQUIRE(out.face >= 0);
      ++tried;
    }
    CHECK(tried > 1'500);
  }
}

TEST_CASE("a line from inside a solid to its edges and corners does not slip out between faces") {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> angle(-180, 180), share(0, 1);
  for (int round = 0; round < 200; ++round) {
    const scene::Placement turned{0.7, {angle(random), angle(random), angle(random)}, {3, -4, 5}};
    const scene::World world = world_of(
        {scene::Box{{-1, -2, -0.5}, {2, 1, 0.25}}, scene::Prism{{0, 0, -1}, {0, 1, 2}, 1.25, 7, 11}}, turned);
    const Solids solids(world);
    for (int b = 0; b < 2; ++b) {
      const Vec3 middle = (world.bodies[b].bounds[0] + world.bodies[b].bounds[1]) / 2.0;
      for (const scene::Face& face : world.bodies[b].faces)
        for (std::size_t k = 0; k < face.outline.size(); ++k) {
          const Vec3 &from = face.outline[k], &to = face.outline[(k + 1) % face.outline.size()];
          const Vec3 aim = from + (to - from) * (k % 2 ? 0.0 : share(random));
          const Vec3 start = middle + random_point(random, 0.05);
          const Line line{start, glm::normalize(aim - start)};
          INFO("seed 18, round " << round << ", body " << b << ", corner " << k << ": " << text(line));
          const auto span = solids.span(b, line);
          REQUIRE(span);
          REQUIRE(span->out.t == Approx(glm::length(aim - start)));
          REQUIRE(solids.exit(b, line).t == span->out.t);
        }
    }
  }
}

TEST_CASE("coinciding faces are met at the same distance, to the bit") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> angle(-180, 180);
  int met = 0;
  for (int round = 0; round < 300; ++round) {
    const scene::Placement turned{1.3, {angle(random), angle(random), angle(random)}, {7, 8, 9}};
    // A cylinder stands on a prism, another is set into it with the same side, and a cone lies flush in a
    // cone.
    const scene::World world = world_of(
        {scene::Prism{{0, 0, 0}, {0, 0, 1}, 2, 8, 22.5}, scene::Frustum{{0, 0, 1}, {0, 0, 3}, 0.7, 0.7},
         scene::Frustum{{0, 0, 1.5}, {0, 0, 2.5}, 0.7, 0.7}, scene::Frustum{{0, 0, 1}, {0, 0, 3}, 1.4, 0.4},
         scene::Frustum{{0, 0, 2}, {0, 0, 1}, 0.9, 1.4}},
        turned);
    const Solids solids(world);
    for (int i = 0; i < 50; ++i) {
      const Vec3 aim =
          (world.bodies[1].bounds[0] + world.bodies[1].bounds[1]) / 2.0 + random_point(random, 0.3);
      const Vec3 direction = random_direction(random);
      const Line line{aim - direction * 20.0, direction};
      std::array<std::optional<Span>, 5> spans;
      for (int b = 0; b < 5; ++b) spans[b] = solids.span(b, line);
      INFO("seed 9, round " << round << ", line " << i << ": " << text(line));
      const auto surface = [&](int body, const Crossing& c) {
        return world.bodies[body].faces[c.face].surface;
      };
      for (int a = 0; a < 5; ++a)
        for (int b = a + 1; b < 5; ++b) {
          if (!spans[a] || !spans[b]) continue;
          for (const Crossing& x : {spans[a]->in, spans[a]->out})
            for (const Crossing& y : {spans[b]->in, spans[b]->out}) {
              // A line may meet a quadric twice.
              if (surface(a, x) != surface(b, y) || std::abs(x.t - y.t) > 0.1) continue;
              REQUIRE(x.t == y.t);
              ++met;
            }
        }
    }
  }
  CHECK(met > 2'000);
}

TEST_CASE("spans scale with the scene, to the bit") {
  std::mt19937_64 random(19);
  const auto all = one_of_each();
  const scene::World middle = world_of(all), large = world_of(all, {0x1p40}),
                     small = world_of(all, {0x1p-40});
  const Solids at_middle(middle), at_large(large), at_small(small);
  for (int i = 0; i < 4'000; ++i) {
    const Vec3 direction = random_direction(random);
    const Vec3 origin = random_point(random, 3) - direction * 10.0;
    for (int b = 0; b < static_cast<int>(all.size()); ++b) {
      const auto span = at_middle.span(b, {origin, direction});
      const auto larger = at_large.span(b, {origin * 0x1p40, direction});
      const auto smaller = at_small.span(b, {origin * 0x1p-40, direction});
      INFO("seed 19, body " << b << ", line " << i);
      REQUIRE(span.has_value() == larger.has_value());
      REQUIRE(span.has_value() == smaller.has_value());
      if (!span) continue;
      REQUIRE(larger->in.t == span->in.t * 0x1p40);
      REQUIRE(smaller->out.t == span->out.t * 0x1p-40);
      REQUIRE(larger->out.face == span->out.face);
    }
  }
}

TEST_CASE(
    "a line near the apex of a cone is judged with an error of the order of rounding, not of its root") {
  // Where the cone's radius is r, the line z = r - k x passes the axis at a distance d. In the plane y = d
  // the cone is x^2 + d^2 <= (1 - z)^2, so the line meets it where d <= r / sqrt(1 - k^2).
  const Solids solids(world_of({scene::Frustum{{0, 0, 0}, {0, 0, 1}, 1, 0}}));
  const double k = 0.6, factor = 1.25;
  const Vec3 direction = glm::normalize(Vec3{1, 0, k});
  for (const double radius : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto meets = [&](double apart) {
      return solids.span(0, {Vec3{0, apart, 1 - radius} - direction, direction}).has_value();
    };
    INFO("radius " << radius);
    CHECK(meets(factor * radius - 2e-15));
    CHECK_FALSE(meets(factor * radius + 2e-15));
  }
}

TEST_CASE("every line has two ends in a solid where its faces have been given those of others") {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const scene::World world = halftone::test::coinciding_cones(random);
  const Solids solids(world);
  int found = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 origin{uniform(random), uniform(random), uniform(random)};
    const Vec3 direction{uniform(random), uniform(random),
                         uniform(random) * std::exp2(-16 * std::abs(uniform(random)))};
    Line line{origin, glm::normalize(direction)};
    if (i % 2 == 0) line.surface = static_cast<int>(random() % world.surfaces.size());
    line.outward = i % 4 == 0;
    for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
      INFO("seed 6, line " << i << ", body " << b);
      if (const auto span = solids.span(b, line)) {
        ++found;
        REQUIRE(span->in.face >= 0);
        REQUIRE(span->out.face >= 0);
      }
      REQUIRE(std::isfinite(solids.exit(b, line).t));
    }
  }
  CHECK(found > 10'000);
}

TEST_CASE("a line that passes the apex of a cone along its side does not end beyond the apex") {
  // At an angle e to a generator, rounding moves the ends by its own size over e; beyond the apex is nothing
  // for it to move them along.
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> uniform(0, 1);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 axis = random_direction(random), apex = random_point(random, 2);
    const double radius = 0.1 + uniform(random);
    const scene::World world = world_of({scene::Frustum{apex - axis, apex, radius, 0}});
    const auto& side = std::get<scene::ConeSurface>(world.surfaces[world.bodies[0].faces[0].surface]);
    const Vec3 across = glm::normalize(glm::cross(axis, random_direction(random)));
    const Vec3 off = random_direction(random) * std::exp2(-53 * uniform(random));
    const Vec3 direction = glm::normalize(axis - across * radius + off);
    const Vec3 along = i % 2 ? direction : -direction;
    const Line line{apex - along * 5.0, along};
    const auto span = Solids(world).span(0, line);
    if (!span) continue;
    ++hits;
    for (const Crossing& end : {span->in, span->out}) {
      const Vec3 point = line.at(end.t);
      INFO("seed 21, line " << i << ": " << text(line));
      REQUIRE(side.radius + side.slope * glm::dot(point - side.origin, side.axis) > -64 * 0x1p-53 * 8);
    }
  }
  CHECK(hits > 5'000);
}
