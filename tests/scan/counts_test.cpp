#include "face_shadows.h"
#include "meeting.h"
#include "support/effort.h"

#include <halftone/scan/band_scanner.h>
#include <halftone/scene/read.h>
#include <halftone/shade/display.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

// That nothing is done which the picture does not need, counted on the ten scenes by other code than the
// scan's.

using namespace halftone;

namespace {

const std::vector<std::string> ten_scenes{"fig9a",   "fig9b",  "contact", "nested", "inside",
                                          "mirrors", "sliver", "cyclic",  "opaque", "round"};

scene::World world_of(const std::string& name) {
  return scene::make_world(scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml"));
}

/// What eye rays find at the corners of pixels, and at a grid of positions in each.
class Picture {
public:
  explicit Picture(const scene::World& world) : world_(world), tracer_(world), all_(world.bodies.size()) {
    std::iota(all_.begin(), all_.end(), 0);
    const int width = world.camera.width, height = world.camera.height;
    std::vector<std::uint8_t> corners;
    for (int y = 0; y <= height; ++y)
      for (int x = 0; x <= width; ++x) corners.push_back(needs_tree(x, y));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto at = [&](int u, int v) { return corners[v * (width + 1) + u]; };
        traced.push_back(at(x, y) && at(x + 1, y) && at(x, y + 1) && at(x + 1, y + 1) ? 1 : 0);
        touched.push_back(at(x, y) || at(x + 1, y) || at(x, y + 1) || at(x + 1, y + 1) ? 1 : 0);
      }
    for (int y = 0; y < height; ++y) find_boundaries(y);
  }

  std::vector<std::uint8_t> traced;   ///< of each pixel: all of its corners see what needs a ray tree
  std::vector<std::uint8_t> touched;  ///< one of them does
  std::vector<std::uint8_t> boundary; ///< not all of its positions see the same through the whole tree
  std::vector<std::uint8_t> steep;    ///< they do, but their colours are more than 8 levels apart

private:
  static constexpr int per_side = 4;

  bool needs_tree(double x, double y) const {
    const reference::Line line{world_.camera.eye, world_.camera.direction(x, y), -1, false};
    const auto meeting =
        reference::next_meeting(world_, line, reference::solids_around(world_, world_.camera.eye));
    if (!meeting) return false;
    std::vector<int> bodies;
    if (meeting->ahead.opaque.body >= 0) bodies.push_back(meeting->ahead.opaque.body);
    for (const auto& met : meeting->ahead.entries) bodies.push_back(met.body);
    for (const auto& met : meeting->exits) bodies.push_back(met.body);
    return std::any_of(bodies.begin(), bodies.end(), [&](int body) {
      const scene::Body& met = world_.bodies[body];
      return met.traced;
    });
  }

  void find_boundaries(int y) {
    const int width = world_.camera.width;
    std::vector<trace::EyeRay> rays;
    for (int x = 0; x < width; ++x) {
      if (!traced[y * width + x]) continue;
      for (int j = 0; j <= per_side; ++j)
        for (int i = 0; i <= per_side; ++i)
          rays.push_back({world_.camera.direction(x + i * 1.0 / per_side, y + j * 1.0 / per_side), all_});
    }
    std::vector<trace::Sample> samples(rays.size());
    trace::Counts counts;
    tracer_.trace(rays, samples, counts);
    std::size_t next = 0;
    for (int x = 0; x < width; ++x) {
      if (!traced[y * width + x]) {
        boundary.push_back(touched[y * width + x]);
        steep.push_back(0);
        continue;
      }
      bool differs = false;
      core::Color low = samples[next].radiance, high = low;
      for (const std::size_t first = next; next < first + (per_side + 1) * (per_side + 1); ++next) {
        differs = differs || samples[next].tree != samples[first].tree;
        low = glm::min(low, samples[next].radiance);
        high = glm::max(high, samples[next].radiance);
      }
      boundary.push_back(differs);
      double most = 0;
      for (int channel = 0; channel < 3; ++channel)
        most = std::max(most, shade::display_level(high[channel], world_.image) -
                                  shade::display_level(low[channel], world_.image));
      steep.push_back(!differs && most > 8);
    }
  }

  const scene::World& world_;
  trace::Tracer tracer_;
  std::vector<int> all_;
};

/// Whether the region covers the middle of a row at x.
bool covers(const scan::Outline& outline, int row, double x) {
  const double y = row + 0.5;
  if (y < outline.top || y > outline.bottom) return false;
  const scan::RowOutline in_row = outline.in_row(row);
  return std::all_of(in_row.edges.begin(), in_row.edges.end(), [&](const scan::RowEdge& row_edge) {
    const auto& [upper, lower, inside_left] = row_edge.edge;
    if (y < upper.y || y >= lower.y) return true;
    const double at = upper.x + (y - upper.y) / (lower.y - upper.y) * (lower.x - upper.x);
    return inside_left ? x <= at : x >= at;
  });
}

} // namespace

// Scouts and the lines that two bands sample both come on top: they are counted from where the pixels are.
TEST_CASE("where the whole tree is one smooth thing, a pixel costs one eye ray, and scouts",
          test::long_when_sanitized) {
  long plain = 0, plain_samples = 0;
  for (const std::string& name : ten_scenes) {
    const scene::World world = world_of(name);
    const Picture picture(world);
    const scan::Frame frame(world);
    scan::BandScanner scanner(frame, 0.25);
    const int width = world.camera.width, height = world.camera.height;
    // Samples on a side count for the pixel below or to the right; those beside boundaries are probed.
    const auto is_plain = [&](int x, int y) {
      for (int v = std::max(0, y - 2); v <= std::min(height - 1, y + 2); ++v)
        for (int u = std::max(0, x - 2); u <= std::min(width - 1, x + 2); ++u)
          if (picture.boundary[v * width + u] || picture.steep[v * width + u]) return false;
      return picture.traced[y * width + x] != 0;
    };
    long pixels = 0, samples = 0, scouts = 0; // of plain ones
    for (int top = 0; top < height; top += 32) {
      const int rows = std::min(32, height - top);
      const auto band = scanner.scan({top, rows});
      for (int y = top; y < top + rows; ++y)
        for (int x = 0; x < width; ++x) {
          if (!is_plain(x, y)) continue;
          ++pixels;
          samples += band[y - top].notes[x].samples;
          // Three on a side of each pixel at quality 0.25; those of the last line of a band, and its corner,
          // count for its last row.
          if (y == top) scouts += 3;
          if (y == top + rows - 1) scouts += 4;
          if (x % 32 == 0) scouts += 3;
        }
    }
    INFO(name << ": " << samples << " samples and " << scouts << " scouts in " << pixels << " pixels");
    if (pixels > 500) CHECK(4 * (samples - scouts) < 5 * pixels);
    plain += pixels;
    plain_samples += samples - scouts;
  }
  CHECK(plain > 50'000);
  CHECK(10 * plain_samples < 11 * plain);
}

TEST_CASE("casters that are listed at a point are at most 1.5 times those that stand there",
          test::long_when_sanitized) {
  long all_listed = 0, all_true = 0;
  for (const std::string& name : ten_scenes) {
    const scene::World world = world_of(name);
    const scan::Frame frame(world);
    order::Order order(world, frame.hulls);
    scan::FaceShadows shadows(frame);
    long listed = 0, standing = 0;
    for (int row = 1; row < world.camera.height; row += 3) {
      const double y = row + 0.5;
      for (const scan::Interval& interval :
           scan::visible_intervals(frame, scan::active_in(frame, y, y), order, y)) {
        if (interval.face < 0 || !interval.candidates.empty()) continue;
        const scan::ScreenFace& face = frame.faces[interval.face];
        std::uint64_t comparisons = 0;
        const auto& regions = shadows.on(interval.face, comparisons).all;
        for (double x = std::ceil(interval.left) + 0.5; x < interval.right; x += 3) {
          const core::Vec3 point =
              world.camera.eye + frame.screen.direction(x, y) / face.inverse_depth.at(x, y);
          const int surface = world.bodies[face.body].faces[face.face].surface;
          for (const scan::FaceShadow& region : regions) {
            if (!covers(region.outline, row, x)) continue;
            ++listed;
            trace::Counts counts;
            const std::array caster{region.caster};
            const auto visible =
                frame.tracer.visibility({point, surface, face.body}, region.light, caster, counts);
            if (visible.value != core::Color{1}) ++standing;
          }
        }
      }
    }
    INFO(name << ": " << listed << " casters listed, " << standing << " stand there");
    CHECK(2 * listed <= 3 * standing);
    all_listed += listed;
    all_true += standing;
  }
  CHECK(all_true > 10'000);
  CHECK(10 * all_listed < 11 * all_true);
}
