// Batches of refracted rays among glass solids of all kinds that do not touch: half of the rays have just
// entered a solid, half have just left one. What they see is found with the identity of the surface and its
// normal there. Whole trees are those of eye rays at solids, of which the reflected branches are cut off
// where anything is refracted: chains of refracted rays, with all that the tracer does at a boundary besides.

#include "micro.h"

#include "inside_sets.h"
#include "prepared.h"
#include "rays.h"
#include "seen.h"

#include <halftone/shade/fresnel.h>
#include <halftone/trace/trace.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>

namespace halftone::micro {

namespace {

constexpr double ior = 1.5;
constexpr int batch = 1024;

/// Spheres, cylinders, cones, frusta and boxes in turn.
scene::Shape shape_of_kind(int kind) {
  constexpr double half = 0.3;
  switch (kind % 5) {
  case 0:
    return scene::Sphere{{0, 0, 0}, half};
  case 1:
    return scene::Frustum{{0, 0, -half}, {0, 0, half}, half, half};
  case 2:
    return scene::Frustum{{0, 0, -half}, {0, 0, half}, half, 0};
  case 3:
    return scene::Frustum{{0, 0, -half}, {0, 0, half}, half, half / 2};
  default:
    return scene::Box{{-half, -half, -half / 2}, {half, half, half / 2}};
  }
}

/// The solids stand in a cube, one in each unit of it, turned at random; a solid is at most 0.91 in size.
scene::Scene glass_field(int solids) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> degrees(-180, 180);
  const int side = static_cast<int>(std::ceil(std::cbrt(solids) - 1e-9));
  scene::Scene built;
  built.image.width = built.image.height = 32;
  built.camera = {
      {-1.5 * side, -2.0 * side, 1.2 * side}, {0.5 * side, 0.5 * side, 0.5 * side}, {0, 0, 1}, 40};
  built.trace = {8, 0.3, 24}; // of what is reflected, only the whole is followed
  built.materials.resize(1);
  built.materials[0].glass = scene::Glass{ior, core::Color{0.05}};
  built.materials[0].diffuse = core::black;
  for (int i = 0; i < solids; ++i) {
    scene::Object& object = built.objects.emplace_back();
    object.shape = shape_of_kind(i);
    const double x = degrees(random), y = degrees(random), z = degrees(random);
    object.placement.rotate = {x, y, z};
    object.placement.translate = {0.5 + i % side, 0.5 + i / side % side, 0.5 + i / side / side};
  }
  return built;
}

core::Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return glm::normalize(core::Vec3{x, y, z});
}

struct Field {
  explicit Field(int solids)
      : world(scene::make_world(glass_field(solids))),
        prepared(world, trace::Search::by_number, core::widest_simd()),
        sets(prepared.media),
        tracer(world) {}

  const scene::World world;
  const trace::Prepared prepared;
  trace::InsideSets sets;
  const trace::Tracer tracer;
};

int any_solid(const Field& field, std::mt19937_64& random) {
  return std::uniform_int_distribution<int>(0, static_cast<int>(field.world.bodies.size()) - 1)(random);
}

/// Near the middle of the solid, and mostly in it.
core::Vec3 point_of(const Field& field, int solid, std::mt19937_64& random) {
  std::uniform_real_distribution<double> offset(-0.2, 0.2);
  const double x = offset(random), y = offset(random), z = offset(random);
  const std::array<core::Vec3, 2>& bounds = field.world.bodies[solid].bounds;
  return (bounds[0] + bounds[1]) / 2.0 + core::Vec3{x, y, z};
}

/// Through random points of random solids; each is bent where the line enters the solid or leaves it.
std::vector<trace::Ray> refracted_rays(Field& field) {
  std::mt19937_64 random(2);
  std::vector<trace::Ray> rays;
  while (rays.size() < batch) {
    const int solid = any_solid(field, random);
    const scene::Body& body = field.world.bodies[solid];
    const core::Vec3 direction = random_direction(random);
    const geometry::Line line{point_of(field, solid, random) - direction, direction};
    const auto span = field.prepared.solids.span(solid, line);
    if (!span) continue;
    const bool enters = rays.size() % 2 == 0;
    const geometry::Crossing& crossing = enters ? span->in : span->out;
    const scene::Face& face = body.faces[crossing.face];
    core::Vec3 normal = scene::normal_at(field.world.surfaces[face.surface], line.at(crossing.t));
    const bool along = glm::dot(normal, direction) > 0; // to the side of the surface's own normal
    if (along) normal = -normal;
    const auto bent = shade::refract(direction, normal, enters ? 1.0 : ior, enters ? ior : 1.0);
    if (!bent) continue;
    const int inside = field.sets.number_of(enters ? std::vector<int>{solid} : std::vector<int>{});
    rays.push_back({line.at(crossing.t),
                    *bent,
                    core::Color{1},
                    face.surface,
                    along,
                    false,
                    false,
                    inside,
                    static_cast<int>(rays.size()),
                    {}});
  }
  return rays;
}

void time_seen(benchmark::State& state, const std::shared_ptr<Field>& field) {
  const std::vector<trace::Ray> sent = refracted_rays(*field);
  std::vector<trace::Ray> rays;
  trace::SeenScratch scratch;
  trace::Mets mets;
  std::vector<trace::Seen> seen(sent.size());
  int hits = 0;
  for (auto _ : state) {
    rays = sent; // finding moves them
    mets.clear();
    trace::find_seen(field->prepared, field->sets, rays, {}, scratch, mets, seen);
    hits = 0;
    core::Vec3 sum{0};
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto& [kind, met, before, behind] = seen[i];
      if (kind == trace::SeenKind::nothing) continue;
      ++hits;
      const scene::Face& face = field->world.bodies[met.body].faces[met.face];
      sum += scene::normal_at(field->world.surfaces[face.surface], rays[i].origin);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sent.size()));
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(sent.size());
}

void time_trees(benchmark::State& state, const std::shared_ptr<Field>& field) {
  std::vector<int> bodies(field->world.bodies.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  std::mt19937_64 random(3);
  std::vector<trace::EyeRay> eye;
  for (int i = 0; i < batch; ++i)
    eye.push_back(
        {glm::normalize(point_of(*field, any_solid(*field, random), random) - field->world.camera.eye),
         bodies});
  std::vector<trace::Sample> samples(eye.size());
  trace::Counts counts;
  for (auto _ : state) {
    field->tracer.trace(eye, samples, counts);
    benchmark::DoNotOptimize(samples.data());
  }
  const double all = static_cast<double>(counts.eye + counts.reflected + counts.refracted);
  state.SetItemsProcessed(static_cast<std::int64_t>(all));
  state.counters["refracted"] = static_cast<double>(counts.refracted) / all;
}

} // namespace

void add_refracted_rays() {
  for (const int solids : {8, 32, 100, 300, 1000}) {
    const auto field = std::make_shared<Field>(solids);
    const std::string of = "/" + std::to_string(solids);
    benchmark::RegisterBenchmark(("refracted rays, what they see" + of).c_str(), time_seen, field);
    benchmark::RegisterBenchmark(("refracted rays, whole trees" + of).c_str(), time_trees, field);
  }
}

} // namespace halftone::micro
