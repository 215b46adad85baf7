#include "root_tally.h"
#include "support/random_scene.h"

#include <catch2/catch.hpp>

// Where lines enter and leave round solids, against exact arithmetic: grazing, along the axis, through the
// apex, along generators, on rims, in the planes of caps, from inside and from 10^8 sizes away, at scales
// from 2^-190 to 2^190.

using namespace halftone;
using core::Vec3;

namespace {

enum class Kind { anywhere, grazing, on_axis, at_apex, on_generator, on_rim, in_cap, inside };
const char* const kind_names[] = {"anywhere",          "grazing",  "on the axis",      "through the apex",
                                  "along a generator", "on a rim", "in a cap's plane", "inside"};
const Kind sphere_kinds[] = {Kind::anywhere, Kind::grazing, Kind::on_axis, Kind::inside};

enum class Round { sphere, cylinder, cone, frustum };

/// The shape's numbers, of a sphere too: lines are aimed by them.
struct Aims {
  Vec3 base{0}, axis{0};
  double height = 0, base_radius = 0, top_radius = 0;
  double size = 0;

  double slope() const { return (top_radius - base_radius) / height; }
};

Vec3 random_vector(test::RandomScene& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// Often nothing, else of any order of magnitude down to rounding.
double little(test::RandomScene& random) {
  const int sign = random.pick(3) - 1;
  return sign * std::exp2(random.uniform(-60, -20));
}

Vec3 unit_across(test::RandomScene& random, const Vec3& normal) {
  return glm::normalize(glm::cross(normal, random_vector(random)));
}

Aims random_aims(test::RandomScene& random, Round shape, double scale) {
  Aims aims;
  aims.base = 5.0 * scale * random_vector(random);
  aims.axis = glm::normalize(random_vector(random));
  aims.height = scale * std::exp2(random.uniform(-10, 10));
  aims.base_radius = aims.top_radius = scale * std::exp2(random.uniform(-10, 10));
  if (shape == Round::cone) aims.top_radius = 0;
  if (shape == Round::frustum) aims.top_radius *= random.uniform(0.1, 3);
  if (shape == Round::sphere) aims.height = 0;
  aims.size = std::max({aims.height, aims.base_radius, aims.top_radius});
  return aims;
}

scene::Shape shape_of(const Aims& aims, bool is_turned) {
  if (aims.height == 0) return scene::Sphere{aims.base, aims.base_radius};
  const Vec3 top = aims.base + aims.axis * aims.height;
  if (is_turned) return scene::Frustum{top, aims.base, aims.top_radius, aims.base_radius};
  return scene::Frustum{aims.base, top, aims.base_radius, aims.top_radius};
}

struct Aim {
  Vec3 target{0}, direction{0};
};

Aim at_sphere(test::RandomScene& random, const Aims& aims, Kind kind) {
  const Vec3 out = glm::normalize(random_vector(random));
  if (kind == Kind::grazing) {
    const Vec3 touched = aims.base + out * (aims.base_radius * (1 + little(random)));
    return {touched, glm::normalize(unit_across(random, out) + out * little(random))};
  }
  if (kind == Kind::on_axis) return {aims.base + random_vector(random) * (aims.size * little(random)), out};
  return {aims.base + random_vector(random) * (kind == Kind::inside ? 0.5 : 1.1) * aims.base_radius, out};
}

Aim at_frustum(test::RandomScene& random, const Aims& aims, Kind kind) {
  const Vec3 radial = unit_across(random, aims.axis), any = random_vector(random);
  const auto radius_at = [&](double share) {
    return aims.base_radius + (aims.top_radius - aims.base_radius) * share;
  };
  const double share = random.uniform(0, 1);
  const int end = random.pick(2);
  const Vec3 on_axis = aims.base + aims.axis * (aims.height * share);
  const Vec3 on_side = on_axis + radial * radius_at(share);
  const Vec3 end_center = aims.base + aims.axis * (aims.height * end);
  const Vec3 normal = glm::normalize(radial - aims.axis * aims.slope());
  const Vec3 generator = glm::normalize(aims.axis + radial * aims.slope());
  const Vec3 off = any * little(random);
  const auto apex = [&] { return aims.base - aims.axis * (aims.base_radius / aims.slope()); };
  switch (kind) {
  case Kind::grazing: {
    const Vec3 along = random.pick(4) == 0 ? generator + glm::cross(normal, generator) * little(random)
                                           : unit_across(random, normal);
    return {on_side + normal * (aims.size * little(random)), along + normal * little(random)};
  }
  case Kind::on_axis:
    return {on_axis + any * (aims.size * little(random)), aims.axis + off};
  case Kind::at_apex:
    if (aims.slope() == 0) return {on_axis, any};
    return {apex() + any * (aims.size * little(random)), random.pick(2) == 0 ? any : generator + off};
  case Kind::on_generator:
    return {on_side + normal * (aims.size * little(random)), generator + off};
  case Kind::on_rim:
    return {end_center + radial * radius_at(end) + off * aims.size,
            random.pick(2) == 0 ? any : glm::cross(aims.axis, radial) + off};
  case Kind::in_cap:
    return {end_center + radial * (radius_at(end) * random.uniform(0, 1.2)) +
                aims.axis * (aims.size * little(random)),
            unit_across(random, aims.axis) + off};
  case Kind::inside:
    return {on_axis + radial * (radius_at(share) * random.uniform(0, 1)), any};
  default:
    return {on_axis + radial * (std::max(aims.base_radius, aims.top_radius) * random.uniform(0, 1.2)), any};
  }
}

void throw_lines(Round shape, std::uint64_t seed, int lines, test::RootTally& tally) {
  test::RandomScene random(seed);
  const double scale = std::ldexp(1.0, random.pick(2) == 0 ? 0 : random.pick(381) - 190);
  const Aims aims = random_aims(random, shape, scale);
  scene::Scene built;
  built.materials.resize(1);
  built.objects.resize(1);
  built.objects[0].shape = shape_of(aims, random.pick(2) == 0);
  const scene::World world = scene::make_world(built);
  const geometry::Solids solids(world);
  const test::ExactRound<test::Twofold> exact(world);
  const test::ExactRound<test::Quad> quad(world);
  for (int number = 0; number < lines; ++number) {
    const bool is_sphere = shape == Round::sphere;
    const Kind kind = is_sphere ? sphere_kinds[random.pick(4)] : static_cast<Kind>(random.pick(8));
    const Aim aim = is_sphere ? at_sphere(random, aims, kind) : at_frustum(random, aims, kind);
    const Vec3 direction = glm::normalize(random.pick(2) == 0 ? aim.direction : -aim.direction);
    const double far = kind == Kind::inside ? 0 : aims.size * std::pow(10, random.uniform(-1, 8));
    test::Thrown thrown{{aim.target - direction * far, direction, -1, false},
                        kind_names[static_cast<int>(kind)]};
    thrown.unit = test::unit_of(world.bodies[0], thrown.line.origin);
    thrown.seed = seed;
    thrown.number = number;
    const auto ours = solids.span(0, thrown.line);
    const auto error = test::error_of_span<test::Twofold>(exact, ours, thrown);
    test::add(tally, error, thrown);
    if (number % 64 != 0) continue;
    const auto with_quad = test::error_of_span<test::Quad>(quad, ours, thrown);
    const double differs = std::abs(with_quad.roundings - error.roundings);
    tally.oracle.add(differs, !(differs <= test::most_of_oracle), thrown);
  }
}

void check_roots(std::uint64_t seeds, int lines, bool is_long) {
  const std::pair<Round, const char*> shapes[] = {{Round::sphere, "sphere"},
                                                  {Round::cylinder, "cylinder"},
                                                  {Round::cone, "cone"},
                                                  {Round::frustum, "frustum"}};
  for (const auto& [shape, name] : shapes) {
    test::check_roots_of(name, {seeds, lines, is_long}, [&, wanted = shape](std::uint64_t seed, auto& sums) {
      throw_lines(wanted, seed, lines, sums);
    });
  }
}

} // namespace

TEST_CASE("lines enter and leave round solids where exact arithmetic says") { check_roots(200, 250, false); }

TEST_CASE("lines enter and leave round solids where exact arithmetic says: many", "[.][long]") {
  check_roots(400'000, 250, true);
}
