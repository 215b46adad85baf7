// Shadow volumes (F. Crow 1977; Tadamura, Nakamae, Nishita c. 1986, section 3.2) cut by the receiving face's
// plane: a convex polygon in the plane and so on the screen, found once for each face, light and caster
// instead of on each scanline. Casters are looked up by the directions in which the light sees them.
//
// A point Q of the caster at height h over the plane, 0 <= h < H below the light's height H, throws its
// shadow on H Q - h L, divided by H - h. The division is left to the projection, so that a shadow that
// reaches to infinity is clipped to the screen like everything else.
//
// Invariant: the region contains every point of the face on the screen whose segment to the light meets the
// caster.

#include <halftone/shadow/shadows.h>

#include "light_cone.h"

#include <halftone/core/memory.h>
#include <halftone/core/rounding.h>
#include <halftone/geometry/position.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace halftone::shadow {

namespace {

/// With fewer corners than this a shadow is what the screen has left of one: a whole circle has as many after
/// two doublings.
constexpr std::size_t few_corners = 16;

/// A corner of the caster and its height over the receiving plane.
struct Corner {
  Vec3 position{0};
  double height = 0;
};

/// Leaves the part of a polygon on the positive side of a linear function of its corners.
template<typename Height>
void clip(std::vector<Corner>& corners, std::vector<Corner>& kept, Height height) {
  kept.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const double height_a = height(a), height_b = height(b);
    if (height_a >= 0) kept.push_back(a);
    if ((height_a >= 0) == (height_b >= 0)) continue;
    const double s = height_a / (height_a - height_b);
    kept.push_back({a.position + s * (b.position - a.position), a.height + s * (b.height - a.height)});
  }
  std::swap(corners, kept);
}

/// Where the edges of a caster pass through the receiving plane, each edge as often as faces have it.
std::vector<Corner> in_plane(const std::vector<Corner>& corners, const std::vector<std::vector<int>>& faces) {
  std::vector<Corner> crossings;
  for (const std::vector<int>& face : faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Corner &a = corners[face[i]], &b = corners[face[i + 1 < face.size() ? i + 1 : 0]];
      if ((a.height < 0) == (b.height < 0)) continue;
      crossings.push_back({a.position + a.height / (a.height - b.height) * (b.position - a.position), 0});
    }
  return crossings;
}

/// Whether the light is clearly outside the hull and beside the planes of its faces: then each face throws a
/// shadow of its own shape, and together they bound the hull's.
bool throws_outline(const geometry::Hull& hull, const Vec3& light, double tolerance) {
  bool outside = false;
  for (const scene::Plane& plane : hull.planes) {
    const double height = glm::dot(plane.normal, light) - plane.offset;
    if (std::abs(height) <= tolerance) return false;
    outside = outside || height > 0;
  }
  return outside || hull.planes.size() == 1; // a polygon has two sides
}

/// Whether a solid may hold the eye. Then the eye may see points of the face that it stands on, and those do
/// not lie in its shadow.
bool may_hold(const geometry::Hull& hull, const Vec3& eye, double tolerance) {
  return hull.planes.size() > 1 &&
         std::all_of(hull.planes.begin(), hull.planes.end(), [&](const auto& plane) {
           return glm::dot(plane.normal, eye) - plane.offset <= tolerance;
         });
}

/// Of coordinates in the cone of a light; and faces that coincide share the plane of one of them.
double slack(const scene::World& world, const Vec3& light) {
  return core::gamma(64) * (glm::length(light) + 2 * world.extent) + scene::touching_distance(world);
}

} // namespace

/// What a light's casters are to it, and the planes in which it lies.
struct Shadows::Cones {
  std::vector<int> planes;
  std::vector<LightCone> around;
  std::vector<bool> throws_outline;
  geometry::BoundsTree directions; ///< of the cones
};

Shadows::Shadows(const scene::World& world, const view::Screen& screen,
                 const std::vector<geometry::Hull>& hulls, const std::vector<std::vector<int>>& casters,
                 double sagitta)
    : world_(world),
      screen_(screen),
      hulls_(hulls),
      casters_(casters),
      sagitta_(sagitta) {
  auto all = std::make_shared<std::vector<Cones>>();
  for (std::size_t light = 0; light < casters_.size(); ++light) {
    const Vec3& position = world_.lights[light].position;
    Cones cones;
    cones.planes = geometry::planes_through(world_, position);
    for (const int caster : casters_[light]) {
      cones.around.emplace_back(position, hulls_[caster].vertices, slack(world_, position));
      cones.throws_outline.push_back(
          throws_outline(hulls_[caster], position, scene::touching_distance(world_)));
    }
    std::vector<geometry::Bounds> directions;
    for (const LightCone& cone : cones.around) directions.push_back(cone.directions());
    cones.directions = geometry::BoundsTree(directions);
    all->push_back(std::move(cones));
  }
  cones_ = std::move(all);
}

std::size_t Shadows::memory() const {
  using core::memory_of;
  return memory_of(*cones_, [](const Cones& cones) {
    return memory_of(cones.planes) + memory_of(cones.around) + memory_of(cones.throws_outline) +
           cones.directions.memory();
  });
}

const std::vector<Region>& Shadows::on(int body, int face, int light) {
  const std::uint64_t key = (static_cast<std::uint64_t>(body) << 40) |
                            (static_cast<std::uint64_t>(face) << 16) | static_cast<std::uint64_t>(light);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_[key] = find(body, face, light, screen_.whole(), comparisons);
}

/// The plane that a shadow falls on, and the light that throws it.
struct Shadows::Receiver {
  scene::Plane plane; ///< the normal on the light's side
  Vec3 light{0};
  double light_height = 0;

  double height(const Vec3& point) const { return glm::dot(plane.normal, point) - plane.offset; }
};

/// What the loops of a convex caster throw; together they are its outline as the light sees it. Loops are
/// asked for only where some of it has to be clipped: otherwise it is the hull of what its corners throw. Of
/// a caster that sinks into the plane it is the hull of those over it, and of where its edges pass through
/// it.
std::optional<view::ScreenPolygon>
Shadows::thrown(const Receiver& receiver, const std::vector<Vec3>& vertices, const Loops& loops) const {
  const Vec3 light_from_eye = receiver.light - world_.camera.eye;
  const auto throw_corner = [&](const Corner& c) {
    return screen_.clip_point(receiver.light_height * (c.position - world_.camera.eye) -
                              std::max(c.height, 0.0) * light_from_eye);
  };
  std::vector<Corner> all;
  std::vector<view::ScreenPoint> points;
  std::vector<bool> whole; // thrown on the screen
  for (const Vec3& vertex : vertices) {
    all.push_back({vertex, receiver.height(vertex)});
    // What stands on the plane may be under it by rounding, and throws its shadow where it stands.
    const double height = all.back().height;
    const double rounding = core::gamma(8) * (glm::length(vertex) + std::abs(receiver.plane.offset));
    const view::ClipPoint on_plane = throw_corner(all.back());
    whole.push_back(height >= -rounding && height <= receiver.light_height && screen_.sees(on_plane));
    if (whole.back()) points.push_back(screen_.project(on_plane));
  }
  if (points.size() == vertices.size()) return view::convex_hull(std::move(points));
  const std::vector<std::vector<int>> faces = loops();
  bool only_sinks = true;
  for (std::size_t k = 0; k < all.size(); ++k) only_sinks = only_sinks && (whole[k] || all[k].height < 0);
  if (only_sinks) {
    const std::size_t over = points.size();
    const std::vector<Corner> crossings = in_plane(all, faces);
    for (const Corner& crossing : crossings) {
      const view::ClipPoint on_plane = throw_corner(crossing);
      if (screen_.sees(on_plane)) points.push_back(screen_.project(on_plane));
    }
    if (points.size() == over + crossings.size()) return view::convex_hull(std::move(points));
    points.resize(over);
  }
  std::vector<Corner> corners, kept;
  for (const std::vector<int>& loop : faces) {
    if (std::all_of(loop.begin(), loop.end(), [&](int k) { return whole[k]; }) ||
        std::all_of(loop.begin(), loop.end(), [&](int k) { return all[k].height < 0; }))
      continue;
    corners.clear();
    for (const int k : loop) corners.push_back(all[k]);
    clip(corners, kept, [](const Corner& c) { return c.height; });
    clip(corners, kept, [&](const Corner& c) { return receiver.light_height - c.height; });
    std::vector<view::ClipPoint> thrown;
    for (const Corner& c : corners) thrown.push_back(throw_corner(c));
    if (thrown.size() < 3) continue;
    const auto part = screen_.clipped(std::move(thrown));
    if (part) points.insert(points.end(), part->begin(), part->end());
  }
  return view::convex_hull(std::move(points));
}

/// Nothing where the outline is not that of the tangent circle alone: of a sphere that sinks into the plane.
std::optional<view::ScreenPolygon> Shadows::thrown_by_round(const Receiver& receiver, const scene::Body& body,
                                                            const view::ScreenPolygon& around) const {
  const auto [left, right] = std::minmax_element(around.begin(), around.end(),
                                                 [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(around.begin(), around.end(),
                                                 [](const auto& a, const auto& b) { return a.y < b.y; });
  const auto thrown_in_chords = [&](int sides) {
    if (body.kind == scene::BodyKind::frustum) {
      return thrown(receiver, geometry::inscribed_corners(*body.frustum, world_.camera, sides),
                    [&] { return geometry::inscribed_faces(*body.frustum, sides); });
    }
    const auto& sphere = std::get<scene::SphereSurface>(world_.surfaces[body.faces[0].surface]);
    return thrown(receiver, geometry::tangent_circle(sphere, receiver.light, world_.camera, sides), [&] {
      std::vector<int> loop(sides);
      std::iota(loop.begin(), loop.end(), 0);
      return std::vector<std::vector<int>>{loop};
    });
  };
  if (body.kind == scene::BodyKind::sphere) {
    const auto& sphere = std::get<scene::SphereSurface>(world_.surfaces[body.faces[0].surface]);
    if (receiver.height(sphere.center) < sphere.radius - scene::touching_distance(world_))
      return std::nullopt;
  }
  // A grazing light draws a shadow out, and its chords with it. What twice as many chords add is about what
  // was missing, and a quarter of it is missing then, once they are many enough: when what they add has begun
  // to fall. Of a few chords that the screen leaves, two doublings may add little by luck.
  int sides = view::chords_of(std::hypot(right->x - left->x, bottom->y - top->y), sagitta_) / 4;
  auto polygon = thrown_in_chords(sides);
  std::optional<double> added; // by the last doubling
  int small_ones = 0;          // in a row
  while (polygon && 2 * sides <= view::most_chords) {
    sides *= 2;
    auto finer = thrown_in_chords(sides);
    if (!finer) return std::nullopt;
    const std::optional<double> before = std::exchange(added, view::excess(*finer, *polygon));
    polygon = std::move(finer);
    const bool is_small = before && *added <= 2 * sagitta_ && *added <= *before / 2;
    small_ones = is_small ? small_ones + 1 : 0;
    if (small_ones >= (polygon->size() < few_corners ? 2 : 1)) break;
  }
  return polygon;
}

std::vector<Region> Shadows::find(int body, int face, int light, const view::ScreenPolygon& seen,
                                  std::uint64_t& compared) const {
  std::vector<Region> regions;
  const auto& plane = std::get<scene::Plane>(world_.surfaces[world_.bodies[body].faces[face].surface]);
  const Vec3& light_position = world_.lights[light].position;
  const double light_offset = glm::dot(plane.normal, light_position) - plane.offset;
  // On a plane in which the light lies nothing is lit; a side of a stand-in has another normal than its
  // plane.
  const scene::Face& receiving = world_.bodies[body].faces[face];
  const std::vector<int>& planes = (*cones_)[light].planes;
  const bool is_in_plane = std::binary_search(planes.begin(), planes.end(), receiving.surface);
  if (light_offset == 0 || (!receiving.rounded && is_in_plane)) return regions;
  const double side = light_offset > 0 ? 1 : -1;
  const Receiver receiver{{plane.normal * side, plane.offset * side}, light_position, side * light_offset};
  const double tolerance = scene::touching_distance(world_);

  const std::vector<Vec3>& own = world_.bodies[body].faces[face].outline;
  const LightCone receives(light_position, own.empty() ? hulls_[body].vertices : own,
                           slack(world_, light_position));
  std::vector<int> near; // of the casters, ascending
  (*cones_)[light].directions.meeting(receives.directions(), [&](int k) { near.push_back(k); });
  std::sort(near.begin(), near.end());
  compared += near.size();
  for (const int k : near) {
    const int caster = casters_[light][k];
    if (caster == body || !(*cones_)[light].around[k].can_shadow(receives)) continue;
    const geometry::Hull& hull = hulls_[caster];
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Vec3& v : hull.vertices) {
      lowest = std::min(lowest, receiver.height(v));
      highest = std::max(highest, receiver.height(v));
    }
    if (highest <= tolerance || lowest >= receiver.light_height) continue;

    if (!(*cones_)[light].throws_outline[k]) {
      regions.push_back({caster, false, true, screen_.whole(), std::nullopt});
      continue;
    }
    auto outline = thrown(receiver, hull.vertices, [&] { return hull.faces; });
    if (!outline || view::are_apart(*outline, seen)) continue;
    const scene::Body& thrower = world_.bodies[caster];
    const bool flat = thrower.kind == scene::BodyKind::polyhedron || thrower.kind == scene::BodyKind::polygon;
    const bool whole = !may_hold(hull, world_.camera.eye, tolerance);
    const bool dark = flat && whole && !world_.materials[thrower.material].glass;
    auto round = flat || !whole ? std::nullopt : thrown_by_round(receiver, thrower, *outline);
    regions.push_back({caster, dark, false, std::move(*outline), std::move(round)});
  }
  return regions;
}

} // namespace halftone::shadow
