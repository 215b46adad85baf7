// Shadow volumes (F. Crow 1977; Tadamura, Nakamae, Nishita c. 1986, section 3.2) cut by the receiving face's
// plane: a convex polygon in the plane and so on the screen, found once for each face, light and caster
// instead of on each scanline.
//
// A point Q of the caster at height h over the plane, 0 <= h < H below the light's height H, throws its
// shadow on H Q - h L, divided by H - h. The division is left to the projection, so that a shadow that
// reaches to infinity is clipped to the screen like everything else.
//
// Invariant: the region contains every point of the face on the screen whose segment to the light meets the
// caster.

#include <halftone/shadow/shadows.h>

#include <algorithm>

namespace halftone::shadow {

namespace {

using core::Vec3;

/// A corner of the caster and its height over the receiving plane.
struct Corner {
  Vec3 position{0};
  double height = 0;
};

/// The part of a polygon on the positive side of a linear function of its corners.
template<typename Height>
std::vector<Corner> clipped(const std::vector<Corner>& corners, Height height) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const double height_a = height(a), height_b = height(b);
    if (height_a >= 0) kept.push_back(a);
    if ((height_a >= 0) == (height_b >= 0)) continue;
    const double s = height_a / (height_a - height_b);
    kept.push_back({a.position + s * (b.position - a.position), a.height + s * (b.height - a.height)});
  }
  return kept;
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

view::ScreenPolygon whole(const scene::CameraFrame& camera) {
  const double width = camera.width, height = camera.height;
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

} // namespace

const std::vector<Region>& Shadows::on(int body, int face, int light) {
  const std::uint64_t key = (static_cast<std::uint64_t>(body) << 40) |
                            (static_cast<std::uint64_t>(face) << 16) | static_cast<std::uint64_t>(light);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_[key] = find(body, face, light);
}

std::vector<Region> Shadows::find(int body, int face, int light) const {
  std::vector<Region> regions;
  const auto& plane = std::get<scene::Plane>(world_.surfaces[world_.bodies[body].faces[face].surface]);
  const Vec3& light_position = world_.lights[light].position;
  const double light_offset = glm::dot(plane.normal, light_position) - plane.offset;
  if (light_offset == 0) return regions;
  const double side = light_offset > 0 ? 1 : -1;
  const double light_height = side * light_offset;
  const Vec3 light_from_eye = light_position - world_.camera.eye;
  const double tolerance = scene::touching_distance(world_);

  std::vector<double> heights;
  for (int caster = 0; caster < static_cast<int>(hulls_.size()); ++caster) {
    if (caster == body) continue;
    const geometry::Hull& hull = hulls_[caster];
    heights.clear();
    for (const Vec3& v : hull.vertices) heights.push_back(side * (glm::dot(plane.normal, v) - plane.offset));
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    if (*highest <= tolerance || *lowest >= light_height) continue;

    if (!throws_outline(hull, light_position, tolerance)) {
      regions.push_back({caster, false, true, whole(screen_.camera())});
      continue;
    }
    std::vector<view::ScreenPoint> points;
    for (const std::vector<int>& loop : hull.faces) {
      std::vector<Corner> corners;
      for (const int k : loop) corners.push_back({hull.vertices[k], heights[k]});
      corners = clipped(corners, [](const Corner& c) { return c.height; });
      corners = clipped(corners, [&](const Corner& c) { return light_height - c.height; });
      std::vector<view::ClipPoint> thrown;
      for (const Corner& c : corners)
        thrown.push_back(screen_.clip_point(light_height * (c.position - world_.camera.eye) -
                                            std::max(c.height, 0.0) * light_from_eye));
      if (thrown.size() < 3) continue;
      const auto part = screen_.clipped(std::move(thrown));
      if (part) points.insert(points.end(), part->begin(), part->end());
    }
    auto outline = view::convex_hull(std::move(points));
    if (!outline) continue;
    const scene::Body& thrower = world_.bodies[caster];
    const bool flat = thrower.kind == scene::BodyKind::polyhedron || thrower.kind == scene::BodyKind::polygon;
    regions.push_back(
        {caster, flat && !world_.materials[thrower.material].glass, false, std::move(*outline)});
  }
  return regions;
}

} // namespace halftone::shadow
