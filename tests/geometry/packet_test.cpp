#include "shapes.h"

#include "support/random_scene.h"
#include "support/skip.h"

#include <halftone/core/simd.h>
#include <halftone/geometry/packet.h>

#include <catch2/catch.hpp>

#include <limits>
#include <optional>

using namespace shapes;
namespace core = halftone::core;
namespace geometry = halftone::geometry;
using geometry::Line;
using geometry::packet_size;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Those beyond the baseline that the processor has.
std::vector<core::Simd> simds() {
  std::vector<core::Simd> all;
  for (const core::Simd simd : {core::Simd::avx2, core::Simd::avx512})
    if (simd <= core::widest_simd()) all.push_back(simd);
  if (all.empty()) halftone::test::skip_anywhere("the processor has no instruction set beyond the baseline");
  return all;
}

scene::World random_world(std::uint64_t seed) {
  return scene::make_world(halftone::test::RandomScene(seed).make({.objects = 12}));
}

/// Where a line meets a body that it is not in, as the tracer has it: its surface is not met again.
std::optional<geometry::Crossing> entry(const scene::World& world, const geometry::Solids& solids,
                                        const geometry::Balls& balls, int body, const Line& line) {
  if (!balls.may_meet(body, line)) return std::nullopt;
  if (world.bodies[body].kind == scene::BodyKind::polygon) return solids.crossing(body, line);
  const auto span = solids.span(body, line);
  if (!span || world.bodies[body].faces[span->in.face].surface == line.surface) return std::nullopt;
  return geometry::Crossing{std::max(span->in.t, 0.0), span->in.face};
}

/// Free lines, and lines that leave a surface to either side; some along an axis, some to a corner.
Line random_line(const scene::World& world, const geometry::Solids& solids, const geometry::Balls& balls,
                 std::mt19937_64& random) {
  const auto towards_a_body = [&](const Vec3& from) {
    const scene::Body& body = world.bodies[random() % world.bodies.size()];
    const Vec3 middle = (body.bounds[0] + body.bounds[1]) / 2.0, size = body.bounds[1] - body.bounds[0];
    return glm::normalize(middle + random_point(random, 0.4) * size - from);
  };
  const Vec3 origin = random_point(random, 5);
  Line line{origin, towards_a_body(origin)};
  if (random() % 16 == 0) line.direction = {0, random() % 2 ? 1.0 : -1.0, 0};
  if (random() % 64 == 0) line.direction = glm::normalize(Vec3{6, 6, 0} - line.origin);
  if (random() % 3 == 0) return line;
  for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body) {
    const auto meets = entry(world, solids, balls, body, line);
    if (!meets) continue;
    const int surface = world.bodies[body].faces[meets->face].surface;
    const Vec3 at = line.at(meets->t), direction = towards_a_body(at);
    const Vec3 normal = scene::normal_at(world.surfaces[surface], at);
    return {at, direction, surface, glm::dot(normal, direction) > 0};
  }
  return line;
}

} // namespace

TEST_CASE("a packet meets what each of its lines meets, to the bit") {
  for (const core::Simd simd : simds()) {
    long unsure = 0, entered = 0, left = 0, polygons = 0, started = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const scene::World world = random_world(seed);
      const geometry::Solids solids(world);
      const geometry::Balls balls(world);
      const geometry::Packets packets(solids, balls, simd);
      std::vector<int> bodies;   // that are asked
      std::vector<int> can_hold; // a line
      for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
        if (seed % 2 && b == 1) continue;
        bodies.push_back(b);
        if (world.bodies[b].kind != scene::BodyKind::polygon) can_hold.push_back(b);
      }
      std::mt19937_64 random(seed);
      for (int round = 0; round < 250; ++round) {
        std::array<Line, packet_size> lines;
        geometry::Packet packet;
        geometry::Meetings meetings;
        std::array<std::array<int, 2>, packet_size> inside;
        for (std::size_t k = 0; k < packet_size; ++k) {
          lines[k] = random_line(world, solids, balls, random);
          packet.set(k, lines[k]);
          for (int i = 0; i < 2; ++i) {
            const std::size_t number = random() % (6 * can_hold.size());
            inside[k][i] = number < can_hold.size() ? can_hold[number] : -1;
            meetings.inside[i][k] = inside[k][i];
          }
        }
        packets.meet(packet, bodies, meetings);
        for (std::size_t k = 0; k < packet_size; ++k) {
          INFO(core::name(simd) << ", seed " << seed << ", packet " << round << ", line " << k);
          double nearest = infinity;
          int body = -1, face = 0, together = 0;
          bool ends = false;
          for (const int b : bodies) {
            const bool is_in = b == inside[k][0] || b == inside[k][1];
            const auto meets =
                is_in ? std::optional(solids.exit(b, lines[k])) : entry(world, solids, balls, b, lines[k]);
            if (!meets || meets->t > nearest) continue;
            together = meets->t < nearest ? 1 : together + 1;
            nearest = meets->t, body = b, face = meets->face, ends = is_in;
          }
          if (meetings.unsure >> k & 1) {
            ++unsure;
            continue;
          }
          REQUIRE(together <= 1);
          REQUIRE(meetings.body[k] == body);
          REQUIRE(meetings.t[k] == nearest);
          if (body < 0) continue;
          REQUIRE(meetings.face[k] == face);
          REQUIRE((meetings.ends >> k & 1) == (ends ? 1u : 0u));
          ++(ends ? left : entered);
          polygons += world.bodies[body].kind == scene::BodyKind::polygon ? 1 : 0;
          started += lines[k].surface >= 0 ? 1 : 0;
        }
      }
    }
    CHECK(entered > 30'000);
    CHECK(left > 10'000);
    CHECK(polygons > 10'000);
    CHECK(started > 10'000);
    CHECK(unsure < 6'000); // of 80,000: corners, touching bodies, lines that have left both of two
  }
}

TEST_CASE("a packet is blocked as each of its lines is, and leaves out no glass") {
  for (const core::Simd simd : simds()) {
    long blocked = 0, by_glass = 0, clear = 0, unsure = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const scene::World world = random_world(seed);
      const geometry::Solids solids(world);
      const geometry::Balls balls(world);
      const geometry::Packets packets(solids, balls, simd);
      std::vector<int> opaque, glass;
      for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b)
        (world.materials[world.bodies[b].material].glass ? glass : opaque).push_back(b);
      std::mt19937_64 random(seed);
      for (int round = 0; round < 250; ++round) {
        std::array<Line, packet_size> lines;
        geometry::Packet packet;
        geometry::Obstacles obstacles;
        for (std::size_t k = 0; k < packet_size; ++k) {
          lines[k] = random_line(world, solids, balls, random);
          packet.set(k, lines[k]);
          obstacles.distance[k] = std::uniform_real_distribution<double>(0.1, 12)(random);
          obstacles.own[k] = static_cast<double>(random() % world.bodies.size());
        }
        packets.shade(packet, opaque, glass, obstacles);
        for (std::size_t k = 0; k < packet_size; ++k) {
          INFO(core::name(simd) << ", seed " << seed << ", packet " << round << ", line " << k);
          if (obstacles.unsure >> k & 1) {
            ++unsure;
            continue;
          }
          const double distance = obstacles.distance[k];
          bool stands = false;
          for (const int b : opaque) {
            if (b == obstacles.own[k] || !balls.may_meet(b, lines[k])) continue;
            if (world.bodies[b].kind == scene::BodyKind::polygon) {
              const auto crossing = solids.crossing(b, lines[k]);
              stands = stands || (crossing && crossing->t < distance);
              continue;
            }
            auto span = solids.span(b, lines[k]);
            if (!span || world.bodies[b].faces[span->in.face].surface == lines[k].surface) continue;
            if (span->out.t > distance) {
              const double before = distance - span->in.t, behind = span->out.t - distance;
              if (before <= 0 || before < behind) continue;
              span->out.t = distance;
            }
            stands = stands || span->in.t > 0 || span->out.t <= distance;
          }
          REQUIRE((obstacles.blocked >> k & 1) == (stands ? 1u : 0u));
          ++(stands ? blocked : clear);
          if (stands) continue;
          for (std::size_t g = 0; g < glass.size(); ++g) {
            const auto span = balls.may_meet(glass[g], lines[k]) ? solids.span(glass[g], lines[k])
                                                                 : std::optional<geometry::Span>{};
            const geometry::RunsIn& runs = obstacles.glass[g];
            REQUIRE((runs.lines >> k & 1) == (span ? 1u : 0u));
            if (!span) continue;
            REQUIRE(runs[k].in.t == span->in.t);
            REQUIRE(runs[k].in.face == span->in.face);
            REQUIRE(runs[k].out.t == span->out.t);
            REQUIRE(runs[k].out.face == span->out.face);
            ++by_glass;
          }
        }
      }
    }
    CHECK(blocked > 10'000);
    CHECK(clear > 10'000);
    CHECK(by_glass > 3'000);
    CHECK(unsure < 4'000);
  }
}
