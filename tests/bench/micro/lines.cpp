// One line against one solid, of each kind: where it enters and leaves. The lines are aimed anywhere in a
// ball of one and a half times the size of the solid, so that both answers are timed; the share of hits is
// told.

#include "micro.h"

#include <halftone/geometry/solids.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>

namespace halftone::micro {

namespace {

struct Named {
  const char* name;
  scene::Shape shape;
};

/// About 1 in size, around the origin.
std::vector<Named> one_of_each() {
  return {{"sphere", scene::Sphere{{0, 0, 0}, 1}},
          {"cylinder", scene::Frustum{{0, 0, -1}, {0.2, 0, 1}, 0.8, 0.8}},
          {"cone", scene::Frustum{{0, 0, -1}, {0.2, 0, 1}, 0.9, 0}},
          {"frustum", scene::Frustum{{0, 0, -1}, {0.2, 0, 1}, 0.9, 0.5}},
          {"box", scene::Box{{-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7}}},
          {"ten-faced prism", scene::Prism{{0, 0, -0.8}, {0.2, 0, 0.8}, 0.9, 8, 11}}};
}

scene::World world_of(const scene::Shape& shape) {
  scene::Scene built;
  built.camera.target = {1, 0, 0};
  built.materials.emplace_back();
  built.objects.emplace_back().shape = shape;
  return scene::make_world(built);
}

core::Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return glm::normalize(core::Vec3{x, y, z});
}

std::vector<geometry::Line> random_lines() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<geometry::Line> lines(1024);
  for (geometry::Line& line : lines) {
    line.origin = 6.0 * random_direction(random);
    const double radius = 1.5 * std::cbrt(share(random));
    const core::Vec3 target = radius * random_direction(random);
    line.direction = glm::normalize(target - line.origin);
  }
  return lines;
}

void time_lines(benchmark::State& state, const geometry::Solids& solids) {
  const std::vector<geometry::Line> lines = random_lines();
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    double sum = 0;
    for (const geometry::Line& line : lines)
      if (const auto span = solids.span(0, line)) {
        ++hits;
        sum += span->in.t + span->out.t;
      }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(lines.size()));
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(lines.size());
}

} // namespace

void add_lines() {
  for (const Named& each : one_of_each())
    benchmark::RegisterBenchmark((std::string("line/") + each.name).c_str(), time_lines,
                                 geometry::Solids(world_of(each.shape)));
}

} // namespace halftone::micro
