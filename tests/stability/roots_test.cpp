#include "support/random_scene.h"
#include "tally.h"

#include <halftone/geometry/solids.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

// Where a line enters and leaves a round solid, against quadruple precision (2^-112): grazing, along the
// axis, through the apex and the rims, from inside and from 10^8 sizes away.

using namespace halftone;

namespace {

__extension__ typedef __float128 Quad;

/// Newton's method from the double: each step doubles the bits.
Quad root(Quad value) {
  if (!(value > 0)) return 0;
  Quad x = std::sqrt(static_cast<double>(value));
  for (int k = 0; k < 3; ++k) x = (x + value / x) / 2;
  return x;
}

struct QuadVec {
  Quad x, y, z;
};

QuadVec quad(const core::Vec3& v) { return {v.x, v.y, v.z}; }
QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
QuadVec operator+(const QuadVec& a, const QuadVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
QuadVec operator*(Quad s, const QuadVec& a) { return {s * a.x, s * a.y, s * a.z}; }
Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A frustum; a sphere where the height is 0.
struct Shape {
  QuadVec base, axis; ///< of unit length
  Quad height = 0, base_radius = 0, slope = 0;

  /// Negative inside: the largest of the heights over its surfaces.
  Quad height_over(const QuadVec& p) const {
    const QuadVec w = p - base;
    if (height == 0) return root(dot(w, w)) - base_radius;
    const Quad along = dot(w, axis);
    const QuadVec apart = w - along * axis;
    const Quad side = (root(dot(apart, apart)) - (base_radius + slope * along)) / root(1 + slope * slope);
    return std::max({side, -along, along - height});
  }
};

struct Ends {
  Quad in = 0, out = 0;
};

/// Where the line origin + t direction is inside.
std::optional<Ends> exact_span(const Shape& shape, const QuadVec& origin, const QuadVec& direction) {
  std::vector<Quad> ends;
  const QuadVec w = origin - shape.base;
  const Quad dd = dot(direction, direction), da = dot(direction, shape.axis), wa = dot(w, shape.axis);
  const Quad radius = shape.base_radius + shape.slope * wa, grows = shape.slope * da;
  const bool round = shape.height == 0;
  const Quad a = round ? dd : dd - da * da - grows * grows;
  const Quad b = round ? dot(w, direction) : dot(w, direction) - wa * da - radius * grows;
  const Quad c =
      round ? dot(w, w) - shape.base_radius * shape.base_radius : dot(w, w) - wa * wa - radius * radius;
  const Quad discriminant = b * b - a * c;
  if (discriminant >= 0 && a != 0) {
    const Quad q = b > 0 ? -b - root(discriminant) : -b + root(discriminant);
    ends.push_back(q / a);
    if (q != 0) ends.push_back(c / q);
  } else if (a == 0 && b != 0) {
    ends.push_back(-c / (2 * b));
  }
  if (!round && da != 0) {
    ends.push_back(-wa / da);
    ends.push_back((shape.height - wa) / da);
  }
  std::sort(ends.begin(), ends.end());
  std::optional<Ends> span;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if (!(shape.height_over(origin + ((ends[k] + ends[k + 1]) / 2) * direction) < 0)) continue;
    if (!span) span = Ends{ends[k], ends[k + 1]};
    span->out = ends[k + 1];
  }
  return span;
}

scene::Shape random_shape(test::RandomScene& random) {
  const double radius = std::exp2(random.uniform(-10, 10)), height = std::exp2(random.uniform(-10, 10));
  const core::Vec3 at{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
  const core::Vec3 axis =
      glm::normalize(core::Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  switch (random.pick(4)) {
  case 0:
    return scene::Sphere{at, radius};
  case 1:
    return scene::Frustum{at, at + axis * height, radius, radius};
  case 2:
    return scene::Frustum{at, at + axis * height, radius, 0};
  default:
    return scene::Frustum{at, at + axis * height, radius, radius * random.uniform(0.1, 3)};
  }
}

Shape exact(const scene::World& world) {
  const scene::Body& body = world.bodies[0];
  if (body.kind == scene::BodyKind::sphere) {
    const auto& sphere = std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]);
    return {quad(sphere.center), {0, 0, 1}, 0, sphere.radius, 0};
  }
  const scene::Frustum& f = *body.frustum;
  const QuadVec way = quad(f.top) - quad(f.base);
  const Quad height = root(dot(way, way));
  return {quad(f.base), (1 / height) * way, height, f.base_radius,
          (Quad(f.top_radius) - f.base_radius) / height};
}

/// Lines at one shape. The error is how far from the surface a line is said to end, or to be inside or
/// outside where it is not, over 2^-53 (distance + size): the difference of t times the sine of the angle at
/// which the surface is met.
void throw_lines(std::uint64_t seed, int lines, test::Tally& tally) {
  test::RandomScene random(seed);
  scene::Scene built;
  built.materials.resize(1);
  built.objects.resize(1);
  built.objects[0].shape = random_shape(random);
  const scene::World world = scene::make_world(built);
  const geometry::Solids solids(world);
  const Shape shape = exact(world);
  const scene::Body& body = world.bodies[0];
  const core::Vec3 middle = (body.bounds[0] + body.bounds[1]) / 2.0;
  const double size = glm::length(body.bounds[1] - body.bounds[0]) / 2;
  const auto inside_box = [&] {
    const core::Vec3 share{random.uniform(-0.1, 1.1), random.uniform(-0.1, 1.1), random.uniform(-0.1, 1.1)};
    return body.bounds[0] + share * (body.bounds[1] - body.bounds[0]);
  };
  for (int k = 0; k < lines; ++k) {
    const double far = size * std::pow(10, random.uniform(-1, 8));
    core::Vec3 direction =
        glm::normalize(core::Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    core::Vec3 target = inside_box();
    if (body.frustum) { // special ones: along the axis, at its ends, in the planes of the caps
      const scene::Frustum& f = *body.frustum;
      const core::Vec3 axis = glm::normalize(f.top - f.base);
      const int kind = random.pick(8);
      if (kind == 0) direction = axis;
      if (kind == 1) target = f.top;
      if (kind == 2) direction = glm::normalize(glm::cross(axis, direction)), target = f.base;
    }
    const geometry::Line line{target - direction * far, direction, -1, false};
    const auto ours = solids.span(0, line);
    const auto exactly = exact_span(shape, quad(line.origin), quad(line.direction));
    const double scale = 0x1p-53 * (glm::length(line.origin - middle) + size + glm::length(middle));
    const auto which = [&] {
      std::ostringstream text;
      text << "seed " << seed << ", line " << k;
      return text.str();
    };
    const bool exists = exactly && exactly->out > 0;
    if (ours.has_value() != exists) {
      // How deep the line passes in the solid, or by how much it misses it: rounding decides where that is
      // nothing.
      double depth = 0;
      if (exists) {
        const Quad t = (exactly->in + exactly->out) / 2;
        depth = static_cast<double>(-shape.height_over(quad(line.origin) + t * quad(line.direction)));
      } else {
        const Quad t = (Quad(ours->in.t) + ours->out.t) / 2;
        depth = static_cast<double>(shape.height_over(quad(line.origin) + t * quad(line.direction)));
      }
      tally.add(depth / scale, depth > 64 * scale, which());
      continue;
    }
    if (!ours) {
      tally.add(0, false, which());
      continue;
    }
    double worst = 0;
    for (const auto& [t, exact_t] :
         {std::pair{ours->in.t, exactly->in}, std::pair{ours->out.t, exactly->out}}) {
      for (const Quad at : {Quad(t), (Quad(t) + exact_t) / 2}) {
        const Quad off = shape.height_over(quad(line.origin) + at * quad(line.direction));
        worst = std::max(worst, std::abs(static_cast<double>(off)) / scale);
      }
    }
    tally.add(worst, !(worst <= 64), which());
  }
}

test::Tally roots(std::uint64_t shapes, int lines) {
  return test::tally_of("roots", shapes,
                        [&](std::uint64_t seed, auto& tally) { throw_lines(seed, lines, tally); });
}

} // namespace

TEST_CASE("lines enter and leave round solids where quadruple precision says") {
  CHECK(roots(400, 100).failures == 0);
}

TEST_CASE("lines enter and leave round solids where quadruple precision says, many", "[.][long]") {
  CHECK(roots(400'000, 250).failures == 0);
}
