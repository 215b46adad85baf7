#include <halftone/scan/frame.h>

#include <halftone/core/memory.h>
#include <halftone/geometry/position.h>
#include <halftone/order/order.h>
#include <halftone/shadow/casters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::scan {

namespace {

using core::Vec3;

std::vector<geometry::Hull> hulls_of(const scene::World& world) {
  std::vector<geometry::Hull> hulls;
  for (const scene::Body& body : world.bodies) hulls.push_back(geometry::bounding_hull(world, body));
  return hulls;
}

/// Height of the eye over each plane of a hull: which faces look at it.
std::vector<double> eye_heights(const geometry::Hull& hull, const Vec3& eye) {
  std::vector<double> heights;
  for (const scene::Plane& plane : hull.planes) heights.push_back(glm::dot(plane.normal, eye) - plane.offset);
  return heights;
}

std::optional<view::ScreenPolygon> on_screen(const view::Screen& screen, const std::vector<Vec3>& loop) {
  std::vector<view::ClipPoint> corners;
  for (const Vec3& v : loop) corners.push_back(screen.clip_point(v - screen.camera().eye));
  return screen.clipped(std::move(corners));
}

std::optional<view::ScreenPolygon> on_screen(const view::Screen& screen, const geometry::Hull& hull,
                                             int face) {
  std::vector<Vec3> loop;
  for (const int k : hull.faces[face]) loop.push_back(hull.vertices[k]);
  return on_screen(screen, loop);
}

std::pair<double, double> rows(const view::ScreenPolygon& polygon) {
  const auto [top, bottom] = std::minmax_element(polygon.begin(), polygon.end(),
                                                 [](const auto& a, const auto& b) { return a.y < b.y; });
  return {top->y, bottom->y};
}

/// Of a solid seen from outside the faces that look at the eye, from inside all of them.
std::vector<ScreenFace> visible_faces(const view::Screen& screen, const scene::World& world, int body,
                                      const geometry::Hull& hull, const std::vector<double>& heights) {
  const bool is_polygon = world.bodies[body].kind == scene::BodyKind::polygon;
  const bool outside = *std::max_element(heights.begin(), heights.end()) > 0;
  std::vector<ScreenFace> visible;
  for (int face = 0; face < static_cast<int>(hull.faces.size()); ++face) {
    if (!is_polygon && outside && heights[face] <= 0) continue;
    auto outline = on_screen(screen, hull, face);
    const auto inverse_depth = screen.inverse_depth(hull.planes[face]);
    if (!outline || !inverse_depth) continue;
    const auto [top, bottom] = rows(*outline);
    visible.push_back({body, face, std::move(*outline), *inverse_depth, top, bottom});
  }
  return visible;
}

/// Seen from inside the hull, the body may be anywhere.
std::optional<TracedRegion> traced_region(const view::Screen& screen, const scene::World& world, int body,
                                          const geometry::Hull& hull, const std::vector<double>& heights,
                                          bool outside) {
  TracedRegion region{body, {}, screen.camera().height * 1.0, 0};
  if (!outside) return TracedRegion{body, {screen.whole()}, 0, screen.camera().height * 1.0};
  const bool is_polygon = world.bodies[body].kind == scene::BodyKind::polygon;
  for (int face = 0; face < static_cast<int>(hull.faces.size()); ++face) {
    if (!is_polygon && heights[face] <= 0) continue;
    auto outline = on_screen(screen, hull, face);
    if (!outline) continue;
    const auto [top, bottom] = rows(*outline);
    region.top = std::min(region.top, top);
    region.bottom = std::max(region.bottom, bottom);
    region.outlines.push_back(std::move(*outline));
  }
  if (region.outlines.empty()) return std::nullopt;
  return region;
}

/// An eye on a solid's surface meets it at distance zero, which only the tracer understands, and rounding
/// says what its faces look like from there.
bool is_on(const scene::World& world, const scene::Body& body, const Vec3& eye) {
  if (body.kind != scene::BodyKind::polyhedron) return false;
  bool on = false;
  for (const scene::Face& face : body.faces) {
    const geometry::Height height = geometry::height_over(world, world.surfaces[face.surface], eye);
    if (height.is_on())
      on = true;
    else if ((face.flipped ? -height.value : height.value) > 0)
      return false;
  }
  return on;
}

/// Chords for what is seen within the region.
int chords_in(const TracedRegion& region, double sagitta) {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const view::ScreenPolygon& outline : region.outlines)
    for (const view::ScreenPoint& p : outline) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
  return view::chords_of(std::hypot(right - left, region.bottom - region.top), sagitta);
}

/// The outline of a frustum, and each cap that is seen. Of one that is wholly on the screen the outline is
/// the hull of its corners; otherwise faces are clipped one by one.
std::vector<view::ScreenPolygon> outlines_of(const view::Screen& screen, const scene::Frustum& frustum,
                                             int sides) {
  const geometry::Hull hull = geometry::inscribed_hull(frustum, screen.camera(), sides);
  const std::vector<double> heights = eye_heights(hull, screen.camera().eye);
  std::vector<view::ScreenPolygon> outlines;
  std::vector<view::ScreenPoint> points;
  for (const Vec3& vertex : hull.vertices) {
    const view::ClipPoint corner = screen.clip_point(vertex - screen.camera().eye);
    if (screen.sees(corner)) points.push_back(screen.project(corner));
  }
  const bool is_whole = points.size() == hull.vertices.size();
  if (!is_whole) points.clear();
  for (int face = 0; face < static_cast<int>(hull.faces.size()); ++face) {
    if (heights[face] <= 0 || (is_whole && face < sides)) continue;
    auto outline = on_screen(screen, hull, face);
    if (!outline) continue;
    if (!is_whole) points.insert(points.end(), outline->begin(), outline->end());
    if (face >= sides) outlines.push_back(std::move(*outline));
  }
  if (auto whole_outline = view::convex_hull(std::move(points)))
    outlines.push_back(std::move(*whole_outline));
  return outlines;
}

std::vector<TracedShape> shapes_of(const view::Screen& screen, const scene::World& world,
                                   const TracedRegion& region, bool outside, double sagitta) {
  const scene::Body& body = world.bodies[region.body];
  std::vector<view::ScreenPolygon> outlines = region.outlines;
  if (outside && body.kind == scene::BodyKind::frustum)
    outlines = outlines_of(screen, *body.frustum, chords_in(region, sagitta));
  if (outside && body.kind == scene::BodyKind::sphere) {
    const auto& sphere = std::get<scene::SphereSurface>(world.surfaces[body.faces[0].surface]);
    const auto outline =
        on_screen(screen, geometry::tangent_circle(sphere, screen.camera().eye, screen.camera(),
                                                   chords_in(region, sagitta)));
    outlines.clear();
    if (outline) outlines.push_back(*outline);
  }
  std::vector<TracedShape> shapes;
  for (const view::ScreenPolygon& outline : outlines)
    shapes.push_back({region.body, outside, Outline(outline)});
  return shapes;
}

/// Whether the convex region contains all of another one.
bool contains(const view::ScreenPolygon& region, const view::ScreenPolygon& other) {
  bool left = true, right = true;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const view::ScreenPoint &a = region[i], &b = region[(i + 1) % region.size()];
    for (const view::ScreenPoint& p : other) {
      const double turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      left = left && turn >= 0;
      right = right && turn <= 0;
    }
  }
  return left || right;
}

/// Indices of the largest faces on the screen: what hides much.
std::vector<int> largest(const std::vector<ScreenFace>& faces, std::size_t count) {
  std::vector<std::pair<double, int>> by_area;
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    by_area.emplace_back(-std::abs(view::signed_area(faces[f].outline)), f);
  count = std::min(count, by_area.size());
  std::partial_sort(by_area.begin(), by_area.begin() + static_cast<std::ptrdiff_t>(count), by_area.end());
  std::vector<int> indices;
  for (std::size_t k = 0; k < count; ++k) indices.push_back(by_area[k].second);
  return indices;
}

} // namespace

/// Drops faces that lie wholly behind one of the largest: rows need not look at them again.
void Frame::drop_hidden() {
  constexpr std::size_t occluders = 8;
  order::Order order(world, hulls);
  const std::vector<int> front = largest(faces, occluders);
  std::vector<ScreenFace> kept;
  for (const ScreenFace& face : faces) {
    const bool is_hidden = std::any_of(front.begin(), front.end(), [&](int f) {
      return faces[f].body != face.body && contains(faces[f].outline, face.outline) &&
             order.compare(faces[f].body, face.body) == order::Front::first;
    });
    if (is_hidden)
      ++hidden_faces;
    else
      kept.push_back(face);
  }
  faces = std::move(kept);
}

Frame::Frame(const scene::World& drawn, double chord_sagitta, core::Simd widest)
    : world(drawn),
      sagitta(chord_sagitta),
      screen(drawn.camera),
      hulls(hulls_of(drawn)),
      casters(shadow::casters_by_light(drawn, hulls)),
      shadows(drawn, screen, hulls, casters, sagitta),
      tracer(drawn, trace::Search::by_number, widest),
      level(drawn.image),
      simd(widest) {
  for (const scene::Light& light : world.lights)
    light_planes.push_back(geometry::planes_through(world, light.position));
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const scene::Body& body = world.bodies[b];
    const std::vector<double> heights = eye_heights(hulls[b], world.camera.eye);
    const bool on = is_on(world, body, world.camera.eye);
    if (body.traced || on) {
      const bool outside = !on && (body.kind == scene::BodyKind::polygon ||
                                   *std::max_element(heights.begin(), heights.end()) > 0);
      auto region = traced_region(screen, world, b, hulls[b], heights, outside);
      if (!region) continue;
      auto shapes = shapes_of(screen, world, *region, outside, sagitta);
      traced_shapes.insert(traced_shapes.end(), std::make_move_iterator(shapes.begin()),
                           std::make_move_iterator(shapes.end()));
      traced.push_back(std::move(*region));
    } else {
      auto visible = visible_faces(screen, world, b, hulls[b], heights);
      faces.insert(faces.end(), std::make_move_iterator(visible.begin()),
                   std::make_move_iterator(visible.end()));
    }
  }
  drop_hidden();
  for (const ScreenFace& face : faces) face_outlines.emplace_back(face.outline);
  std::vector<geometry::Bounds> rows_of_shapes;
  for (const Outline& outline : face_outlines) rows_of_shapes.push_back(row_bounds(outline));
  for (const TracedShape& shape : traced_shapes) rows_of_shapes.push_back(row_bounds(shape.outline));
  shape_rows = geometry::BoundsTree(rows_of_shapes);
}

std::size_t Frame::memory() const {
  using core::memory_of;
  const auto of_numbers = [](const std::vector<int>& numbers) { return memory_of(numbers); };
  const auto of_polygon = [](const view::ScreenPolygon& polygon) { return memory_of(polygon); };
  return sizeof(Frame) +
         memory_of(hulls, [](const geometry::Hull& hull) { return geometry::memory_of(hull); }) +
         memory_of(casters, of_numbers) + memory_of(light_planes, of_numbers) + shadows.memory() +
         memory_of(faces, [&](const ScreenFace& face) { return of_polygon(face.outline); }) +
         memory_of(traced,
                   [&](const TracedRegion& region) { return memory_of(region.outlines, of_polygon); }) +
         memory_of(face_outlines, [](const Outline& outline) { return outline.memory(); }) +
         memory_of(traced_shapes, [](const TracedShape& shape) { return shape.outline.memory(); }) +
         shape_rows.memory() + tracer.memory();
}

} // namespace halftone::scan
