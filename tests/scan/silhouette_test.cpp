#include "cut.h"
#include "support/effort.h"
#include "support/random_scene.h"

#include <halftone/shadow/shadows.h>

#include <halftone/scan/frame.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <map>
#include <optional>

// Outlines of round bodies, and their shadows, against dense rays: what they say is met and missed 2^-9 of a
// pixel to either side. Chords leave half of that.

using namespace halftone;

namespace {

constexpr double beside = 0x1p-9; // pixels

/// The ends of a region in the middle of a row, and how far from each lies what is `beside` it at a right
/// angle.
struct Ends {
  std::array<double, 2> at{};
  std::array<double, 2> away{};
};

std::optional<Ends> ends_of(const scan::Outline& outline, int row) {
  const double y = row + 0.5;
  if (y < outline.top || y > outline.bottom) return std::nullopt;
  Ends ends{{-1e300, 1e300}, {}};
  for (const scan::RowEdge& row_edge : outline.in_row(row).edges) {
    const scan::Edge& edge = row_edge.edge;
    if (y < edge.upper.y || y >= edge.lower.y) continue;
    const double dx = edge.lower.x - edge.upper.x, dy = edge.lower.y - edge.upper.y;
    const double at = edge.upper.x + (y - edge.upper.y) / dy * dx, away = beside * std::hypot(dx, dy) / dy;
    if (edge.inside_left ? at < ends.at[1] : at > ends.at[0]) {
      ends.at[edge.inside_left] = at;
      ends.away[edge.inside_left] = away;
    }
  }
  return ends;
}

bool is_round(const scene::Body& body) {
  return body.kind == scene::BodyKind::frustum || body.kind == scene::BodyKind::sphere;
}

} // namespace

TEST_CASE("eye rays meet a round body within its outline and miss it without") {
  int tested = 0;
  for (std::uint64_t seed = 1; seed <= 60; seed += test::seed_step) {
    test::RandomScene random(seed);
    const scene::World world = scene::make_world(random.make({9, true, seed % 2 == 0}));
    const scan::Frame frame(world);
    for (int row = 0; row < world.camera.height; ++row) {
      std::map<int, Ends> bodies; // each is the union of its outline and its caps
      for (const scan::TracedShape& shape : frame.traced_shapes) {
        if (!shape.certain || !is_round(world.bodies[shape.body])) continue;
        const auto ends = ends_of(shape.outline, row);
        if (!ends) continue;
        auto& [at, away] = bodies.try_emplace(shape.body, *ends).first->second;
        if (ends->at[0] < at[0]) at[0] = ends->at[0], away[0] = ends->away[0];
        if (ends->at[1] > at[1]) at[1] = ends->at[1], away[1] = ends->away[1];
      }
      for (const auto& [body, ends] : bodies)
        for (const int end : {0, 1}) {
          const double x = ends.at[end], d = ends.away[end], out = end == 0 ? -1 : 1;
          if (x <= 1 || x >= world.camera.width - 1 || d > 4 * beside || ends.at[1] - ends.at[0] < 4 * d)
            continue;
          const auto meets = [&, body = body](double at) {
            const reference::Line line{world.camera.eye, world.camera.direction(at, row + 0.5), -1, false};
            return reference::cut(world, world.bodies[body], line).has_value();
          };
          INFO("seed " << seed << ", body " << body << " at " << x << ", row " << row);
          CHECK(meets(x - out * d));
          CHECK_FALSE(meets(x + out * d));
          ++tested;
        }
    }
  }
  CHECK(tested > 6'000 / static_cast<int>(test::seed_step));
}

TEST_CASE("the shadow of a round body ends where shadow rays begin to miss it") {
  int tested = 0;
  for (std::uint64_t seed = 1; seed <= 60; seed += test::seed_step) {
    test::RandomScene random(seed);
    const scene::World world = scene::make_world(random.make({9, true, false}));
    const scan::Frame frame(world);
    shadow::Shadows shadows(world, frame.screen, frame.hulls, frame.casters);
    for (const scan::ScreenFace& face : frame.faces) {
      const scene::Face& own = world.bodies[face.body].faces[face.face];
      const auto& plane = std::get<scene::Plane>(world.surfaces[own.surface]);
      for (int light = 0; light < static_cast<int>(world.lights.size()); ++light) {
        const core::Vec3& source = world.lights[light].position;
        const double side = glm::dot(plane.normal, source) - plane.offset;
        if ((side > 0) != (glm::dot(plane.normal, world.camera.eye) > plane.offset)) continue;
        for (const shadow::Region& region : shadows.on(face.body, face.face, light)) {
          if (!region.round) continue;
          const view::ScreenPolygon& polygon = *region.round;
          const auto is_dark = [&](double x, double y) {
            const core::Vec3 point =
                world.camera.eye + frame.screen.direction(x, y) / face.inverse_depth.at(x, y);
            const core::Vec3 to_light = source - point;
            const double distance = glm::length(to_light);
            const auto span =
                reference::cut(world, world.bodies[region.caster], {point, to_light / distance, -1, false});
            return span && span->out.t > 0 && span->in.t < distance;
          };
          for (std::size_t k = 0; k < polygon.size(); ++k) {
            const view::ScreenPoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
            const double x = (a.x + b.x) / 2, y = (a.y + b.y) / 2, length = std::hypot(b.x - a.x, b.y - a.y);
            // Edges of the screen are no ends of shadows; next to corners both sides are near.
            if (x < 1 || y < 1 || x > world.camera.width - 1 || y > world.camera.height - 1 || length < 0.05)
              continue;
            const auto extent = view::extent_at(face.outline, y);
            if (!extent || x < extent->left + 0.1 || x > extent->right - 0.1) continue;
            double nx = (b.y - a.y) / length, ny = (a.x - b.x) / length;
            const auto is_inwards = [&] {
              const auto inwards = view::extent_at(polygon, y + beside * ny);
              return inwards && x + beside * nx > inwards->left && x + beside * nx < inwards->right;
            };
            if (!is_inwards()) nx = -nx, ny = -ny;
            if (!is_inwards()) continue; // a needle that is thinner than that
            INFO("seed " << seed << ", body " << face.body << ", caster " << region.caster << ", light "
                         << light << " at " << x << ", " << y);
            CHECK(is_dark(x + beside * nx, y + beside * ny));
            CHECK_FALSE(is_dark(x - beside * nx, y - beside * ny));
            ++tested;
          }
        }
      }
    }
  }
  CHECK(tested > 5'000 / static_cast<int>(test::seed_step));
}
