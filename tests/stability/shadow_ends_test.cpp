#include "exact_solids.h"
#include "support/random_scene.h"
#include "tally.h"

#include <halftone/shadow/shadows.h>
#include <sphere_shadow.h>

#include <catch2/catch.hpp>

#include <array>
#include <numeric>
#include <sstream>
#include <vector>

// Where the border of a shadow on a plane crosses a scanline, against exact arithmetic; with lights that
// graze the plane and eyes that do. The plane through the light and an edge of the caster meets the receiving
// plane in a line, which the picture shows as one. Round casters are drawn as chords, whose corners have to
// lie on the true border.
//
// The condition of an end is the sum, over all numbers that it depends on, of its move in pixels where that
// number changes by the size of the scene (a unit vector's by 1): rounding of the input moves the end by u
// times that. An error is counted in these units, and in 1e-9 pixel times the condition over the picture's
// width, where that is above 1.

using namespace halftone;
using core::Vec3;

namespace {

using Real = test::Twofold;
using Vec = test::ExactVec<Real>;

/// Measured, not derived: the worst of a million boxes is 73.6. 1e-9 pixel is two thousand times as much.
constexpr double most_roundings = 128;

/// What an end depends on. shape: an edge's ends; or a center and an axis, the radius in `radius`.
struct Numbers {
  std::array<Vec, 9> v; ///< light, shape (2), receiver's normal and mean, eye, forward, right, up
  Real radius = 0;
  std::array<double, 9> sizes{}; ///< of the coordinates that each is known to, 1 for unit vectors
  int width = 0, height = 0;

  const Vec& light() const { return v[0]; }
  /// A point of the receiving plane in the picture.
  Vec at(const Real& x, const Real& y) const {
    const Vec ray = v[6] + (2 * x / Real(width) - 1) * v[7] + (1 - 2 * y / Real(height)) * v[8];
    return v[5] + (dot(v[3], v[4] - v[5]) / dot(v[3], ray)) * ray;
  }
};

/// Where the shadow of the edge's line crosses the scanline.
Real crossing(const Numbers& n, const Real& y) {
  const Vec across = cross(n.v[1] - n.light(), n.v[2] - n.light());
  const Vec normal = dot(across, n.v[5] - n.light()) * n.v[3] + dot(n.v[3], n.v[4] - n.v[5]) * across;
  const Vec start = n.v[6] - n.v[7] + (1 - 2 * y / Real(n.height)) * n.v[8];
  return -dot(normal, start) / dot(normal, (2 / Real(n.width)) * n.v[7]);
}

/// How far the light's ray to a place of the picture passes outside of a sphere around v[1].
Real beside_sphere(const Numbers& n, const Real& x, const Real& y) {
  const Vec way = n.at(x, y) - n.light();
  return length(cross(n.v[1] - n.light(), way)) / length(way) - n.radius;
}

/// The same of a circle around v[1] with the axis v[2], in its plane.
Real beside_circle(const Numbers& n, const Real& x, const Real& y) {
  const Vec way = n.at(x, y) - n.light(), to_center = n.v[1] - n.light();
  return length((dot(n.v[2], to_center) / dot(n.v[2], way)) * way - to_center) - n.radius;
}

/// The sum of |df / dnumber| times the number's size.
template<typename F>
double sensitivity(const Numbers& numbers, F f) {
  constexpr double step = 0x1p-45;
  const Real here = f(numbers);
  double sum = 0;
  const auto add = [&](Real Numbers::*radius, int k, Real Vec::*axis, double size) {
    Numbers moved = numbers;
    Real& number = radius ? moved.*radius : moved.v[k].*axis;
    number = number + Real(step * size);
    sum += std::abs(static_cast<double>(f(moved) - here)) / step;
  };
  for (int k = 0; k < 9; ++k)
    for (Real Vec::*axis : {&Vec::x, &Vec::y, &Vec::z}) add(nullptr, k, axis, numbers.sizes[k]);
  add(&Numbers::radius, 0, nullptr, numbers.sizes[1]);
  return sum;
}

struct Tallies {
  test::Tally roundings, pixels;

  void add(double error, double condition, int width, const std::string& where) {
    const double units = error / (0x1p-53 * condition),
                 shares = error / (1e-9 * std::max(1.0, condition / width));
    roundings.add(units, !(units <= most_roundings), where);
    pixels.add(shares, !(shares <= 1), where);
  }
};

enum class Caster { box, prism, polygon, sphere, frustum };
const char* const names[] = {"box", "prism", "polygon", "sphere", "frustum"};

/// The receiver is the plane z = 0 of a frame of its own.
struct Setting {
  scene::Scene scene;
  core::Mat3 frame{1};
  Vec3 origin{0};

  Vec3 at(double x, double y, double z) const { return origin + frame * Vec3{x, y, z}; }
};

Vec3 random_unit(test::RandomScene& random) {
  return glm::normalize(Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
}

/// Two unit vectors across a unit vector.
core::Mat3 random_frame(test::RandomScene& random) {
  const Vec3 z = random_unit(random), x = glm::normalize(glm::cross(z, random_unit(random)));
  return {x, glm::cross(z, x), z};
}

scene::Shape random_caster(test::RandomScene& random, const Setting& setting, Caster kind) {
  const double size = random.uniform(0.1, 1);
  const bool stands = random.pick(3) == 0;
  const bool from_middle = kind == Caster::box || kind == Caster::sphere;
  const Vec3 middle = setting.at(random.uniform(-1, 1), random.uniform(-1, 1),
                                 !stands       ? random.uniform(1.8, 4)
                                 : from_middle ? size
                                               : 0);
  const core::Mat3 turn = stands ? setting.frame : random_frame(random);
  switch (kind) {
  case Caster::box: {
    scene::Polyhedron box;
    const double a = random.uniform(0.05, 1), b = random.uniform(0.05, 1);
    for (int k = 0; k < 8; ++k)
      box.vertices.push_back(middle + size * (turn * Vec3{k & 1 ? a : -a, k & 2 ? b : -b, k & 4 ? 1 : -1}));
    box.faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    return box;
  }
  case Caster::prism:
    return scene::Prism{middle, middle + size * turn[2], size, 3 + random.pick(6), random.uniform(0, 90)};
  case Caster::polygon:
    return scene::Polygon{{middle - size * turn[0], middle + size * turn[1], middle + size * turn[0]}};
  case Caster::sphere:
    return scene::Sphere{middle, size};
  default:
    return scene::Frustum{middle, middle + size * turn[2], size * random.uniform(0.1, 1),
                          random.pick(3) == 0 ? 0 : size * random.uniform(0.1, 1)};
  }
}

/// The light's rays and the eye's meet the plane at angles down to a thousandth; some of the caster may be
/// above the light.
Setting random_setting(test::RandomScene& random, Caster kind) {
  Setting setting;
  setting.frame = random_frame(random);
  setting.origin = 5.0 * random_unit(random);
  scene::Scene& scene = setting.scene;
  scene.image.width = 64;
  scene.image.height = 48;
  const double far = std::exp2(random.uniform(2, 12));
  const double around = random.uniform(0, 6.28);
  scene.lights.push_back(
      {setting.at(far * std::cos(around), far * std::sin(around), random.uniform(1.5, 12)), core::Color{1}});
  scene.camera.eye =
      setting.at(random.uniform(-8, 8), random.uniform(-8, 8), std::exp2(random.uniform(-10, 3)));
  scene.camera.target =
      setting.at(random.uniform(-3, 3) - far * std::cos(around) / 3, -far * std::sin(around) / 3, 0);
  if (random.pick(2) == 0) scene.camera.target = setting.at(random.uniform(-3, 3), random.uniform(-3, 3), 0);
  scene.camera.up = setting.frame[2];
  scene.camera.fov = random.uniform(20, 100);
  scene.materials.resize(1);
  scene.objects.resize(2);
  scene.objects[0].shape = scene::Polygon{
      {setting.at(-9, -9, 0), setting.at(9, -9, 0), setting.at(9, 9, 0), setting.at(-9, 9, 0)}};
  scene.objects[1].shape = random_caster(random, setting, kind);
  return setting;
}

Numbers numbers_of(const scene::World& world) {
  const test::ExactPlane<Real> plane(world.bodies[0].faces[0].outline);
  const scene::CameraFrame& camera = world.camera;
  Numbers numbers{{Vec(world.lights[0].position),
                   {},
                   {},
                   plane.normal,
                   plane.mean,
                   Vec(camera.eye),
                   Vec(camera.forward),
                   Vec(camera.right),
                   Vec(camera.up)}};
  const double light = world.extent + glm::length(world.lights[0].position);
  const double eye = world.extent + glm::length(camera.eye);
  numbers.sizes = {light,
                   world.extent,
                   world.extent,
                   1,
                   world.extent,
                   eye,
                   1,
                   glm::length(camera.right),
                   glm::length(camera.up)};
  numbers.width = camera.width;
  numbers.height = camera.height;
  return numbers;
}

struct End {
  double x = 0, condition = 0;
};

/// Where the shadows of edges between a face in the light and one that is not cross the scanline on the
/// screen.
std::vector<End> exact_ends(Numbers numbers, const geometry::Hull& hull, double y) {
  std::vector<End> ends;
  std::vector<std::array<int, 2>> outline; // edges as lit faces walk them
  const bool is_polygon = hull.faces.size() == 1;
  for (const std::vector<int>& loop : hull.faces) {
    std::vector<Vec3> corners;
    for (const int k : loop) corners.push_back(hull.vertices[k]);
    if (!is_polygon && !(test::ExactPlane<Real>(corners).height(numbers.light()) > 0)) continue;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::array<int, 2> edge{loop[k], loop[(k + 1) % loop.size()]};
      const auto twin = std::find(outline.begin(), outline.end(), std::array<int, 2>{edge[1], edge[0]});
      if (twin == outline.end())
        outline.push_back(edge);
      else
        outline.erase(twin);
    }
  }
  for (const auto& [from, to] : outline) {
    numbers.v[1] = Vec(hull.vertices[from]);
    numbers.v[2] = Vec(hull.vertices[to]);
    const Real x = crossing(numbers, y);
    if (!(x > 0) || !(x < Real(numbers.width))) continue;
    const Vec point = numbers.at(x, y);
    if (!(dot(point - numbers.v[5], numbers.v[6]) > 0)) continue; // behind the eye
    // On the edge itself, not only on its line.
    const Vec across = cross(numbers.v[1] - numbers.light(), numbers.v[2] - numbers.light());
    const Vec beside = cross(point - numbers.light(), across);
    const Real share = dot(beside, numbers.light() - numbers.v[1]) / dot(beside, numbers.v[2] - numbers.v[1]);
    if (share < 0 || share > 1) continue;
    const Vec thrower = numbers.v[1] + share * (numbers.v[2] - numbers.v[1]);
    if (!(dot(numbers.v[3], thrower - numbers.light()) < 0)) continue; // above the light
    ends.push_back(
        {static_cast<double>(x), sensitivity(numbers, [&](const Numbers& n) { return crossing(n, y); })});
  }
  return ends;
}

bool is_on_screen(const Numbers& numbers, double x) { return x > 1e-6 && x < numbers.width - 1e-6; }

double random_height(const view::ScreenPolygon& outline, test::RandomScene& random) {
  double top = outline[0].y, bottom = top;
  for (const view::ScreenPoint& p : outline) top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  return random.uniform(top, bottom);
}

/// Each exact end against the nearer of the region's.
void compare_ends(const Numbers& numbers, const geometry::Hull& hull, const view::ScreenPolygon& outline,
                  test::RandomScene& random, Tallies& tallies, const std::string& where) {
  for (int line = 0; line < 4; ++line) {
    const double y = random_height(outline, random);
    const auto extent = view::extent_at(outline, y);
    const std::vector<End> ends = exact_ends(numbers, hull, y);
    for (const End& end : ends) {
      if (!is_on_screen(numbers, end.x)) continue;
      const double error =
          extent ? std::min(std::abs(extent->left - end.x), std::abs(extent->right - end.x)) : 1e300;
      tallies.add(error, end.condition, numbers.width, where + ", line " + std::to_string(line));
    }
    for (const double x : {extent ? extent->left : 0, extent ? extent->right : 0})
      if (is_on_screen(numbers, x) && ends.empty()) tallies.add(1e300, 1, numbers.width, where + ", no end");
  }
}

/// f(numbers, x, y) is 0 on the true border; error and condition as lengths in the picture, along x alone or
/// at a right angle to the border.
template<typename F>
void compare_place(const Numbers& numbers, F f, double x, double y, bool along_x, Tallies& tallies,
                   const std::string& where) {
  constexpr double step = 0x1p-40;
  const double off = static_cast<double>(f(numbers, x, y));
  const double slope_x = static_cast<double>(f(numbers, Real(x) + step, y) - f(numbers, x, y)) / step;
  const double slope_y = static_cast<double>(f(numbers, x, Real(y) + step) - f(numbers, x, y)) / step;
  const double slope = along_x ? std::abs(slope_x) : std::hypot(slope_x, slope_y);
  const double condition = sensitivity(numbers, [&](const Numbers& n) { return f(n, x, y); }) / slope;
  tallies.add(std::abs(off) / slope, condition, numbers.width, where);
}

/// The plane cuts chords of circles that stand on it anywhere between their ends.
bool is_corner(const view::ScreenPolygon& outline, std::size_t k) {
  const view::ScreenPoint &a = outline[(k + outline.size() - 1) % outline.size()], &b = outline[k],
                          &c = outline[(k + 1) % outline.size()];
  const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return std::abs(twice) > 1e-9 * std::hypot(c.x - a.x, c.y - a.y);
}

void compare_corners(Numbers numbers, const scene::World& world, const view::ScreenPolygon& outline,
                     Tallies& tallies, const std::string& where) {
  const scene::Body& body = world.bodies[1];
  for (std::size_t k = 0; k < outline.size(); k += 1 + outline.size() / 8) {
    const double x = outline[k].x, y = outline[k].y;
    if (!is_corner(outline, k) || !is_on_screen(numbers, x) || !(y > 1e-6 && y < numbers.height - 1e-6))
      continue; // on a chord, or cut by the screen
    if (!(static_cast<double>(length(numbers.at(x, y))) < 1e9))
      continue; // at the horizon, by the light's plane
    const std::string place = where + ", corner " + std::to_string(k);
    if (body.kind == scene::BodyKind::sphere) {
      const auto& sphere = std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]);
      numbers.v[1] = Vec(sphere.center);
      numbers.radius = sphere.radius;
      compare_place(numbers, beside_sphere, x, y, false, tallies, place);
      continue;
    }
    const scene::Frustum& f = *body.frustum;
    numbers.v[2] = Vec(f.top) - Vec(f.base);
    numbers.v[2] = (1 / length(numbers.v[2])) * numbers.v[2];
    Numbers at_top = numbers;
    numbers.v[1] = Vec(f.base);
    numbers.radius = f.base_radius;
    at_top.v[1] = Vec(f.top);
    at_top.radius = f.top_radius;
    const auto off = [&](const Numbers& n) { return std::abs(static_cast<double>(beside_circle(n, x, y))); };
    compare_place(off(numbers) < off(at_top) ? numbers : at_top, beside_circle, x, y, false, tallies, place);
  }
}

/// The ends that scanlines take for a sphere's shadow instead of chords.
void compare_sphere(Numbers numbers, const scan::Frame& frame, const view::ScreenPolygon& outline,
                    test::RandomScene& random, Tallies& tallies, const std::string& where) {
  const auto& sphere =
      std::get<scene::SphereSurface>(frame.world.surfaces[frame.world.bodies[1].faces[0].surface]);
  numbers.v[1] = Vec(sphere.center);
  numbers.radius = sphere.radius;
  const auto floor = std::find_if(frame.faces.begin(), frame.faces.end(),
                                  [](const scan::ScreenFace& face) { return face.body == 0; });
  if (floor == frame.faces.end()) return;
  for (int line = 0; line < 4; ++line) {
    const double y = random_height(outline, random);
    const auto extent = view::extent_at(outline, y);
    if (!extent) continue;
    const auto shadow = scan::exact_sphere_shadow(frame, *floor, 1, 0, y, *extent);
    if (!shadow || !shadow->extent) continue;
    for (const double x : {shadow->extent->left, shadow->extent->right})
      if (x != extent->left && x != extent->right)
        compare_place(numbers, beside_sphere, x, y, true, tallies, where + ", line " + std::to_string(line));
  }
}

void throw_shadow(Caster kind, std::uint64_t seed, Tallies& tallies, Tallies& on_lines) {
  test::RandomScene random(seed);
  const Setting setting = random_setting(random, kind);
  const scene::World world = scene::make_world(setting.scene);
  const scan::Frame frame(world);
  const std::vector<std::vector<int>> casters{{0, 1}};
  shadow::Shadows shadows(world, frame.screen, frame.hulls, casters);
  std::ostringstream text;
  text << "seed " << seed << ", " << names[static_cast<int>(kind)];
  for (const shadow::Region& region : shadows.on(0, 0, 0)) {
    if (region.anywhere) continue;
    if (world.bodies[1].kind == scene::BodyKind::polyhedron ||
        world.bodies[1].kind == scene::BodyKind::polygon)
      compare_ends(numbers_of(world), frame.hulls[1], region.outline, random, tallies, text.str());
    else if (region.round)
      compare_corners(numbers_of(world), world, *region.round, tallies, text.str());
    if (kind == Caster::sphere)
      compare_sphere(numbers_of(world), frame, region.outline, random, on_lines, text.str());
  }
}

/// least: cases, so that none passes for lack of them.
void check(const std::string& family, const Tallies& tallies, std::uint64_t least) {
  test::tell("shadow ends: " + family + ", roundings", tallies.roundings);
  test::tell("shadow ends: " + family + ", 1e-9 pixel by condition", tallies.pixels);
  CHECK(tallies.roundings.cases >= least);
  CHECK(tallies.roundings.failures == 0);
  CHECK(tallies.pixels.failures == 0);
}

void check_ends(std::uint64_t seeds) {
  Tallies on_lines;
  for (const Caster kind : {Caster::box, Caster::prism, Caster::polygon, Caster::sphere, Caster::frustum}) {
    Tallies tallies;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) throw_shadow(kind, seed, tallies, on_lines);
    check(names[static_cast<int>(kind)], tallies, 2 * seeds);
  }
  check("sphere by scanline", on_lines, 2 * seeds);
}

} // namespace

TEST_CASE("shadows end on scanlines where exact arithmetic says") { check_ends(300); }

TEST_CASE("shadows end on scanlines where exact arithmetic says: many", "[.][long]") { check_ends(200'000); }
