// Whole pictures by area, on one thread, with all that is prepared for them. An item is a row.

#include "micro.h"

#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <benchmark/benchmark.h>

#include <string>

namespace halftone::micro {

namespace {

void time_rows(benchmark::State& state, const scene::Scene& scene) {
  double sum = 0;
  for (auto _ : state)
    render::render(scene, {.threads = 1}, [&](const render::Row& row) { sum += row.radiance[0].r; });
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(state.iterations() * scene.image.height);
}

} // namespace

void add_rows() {
  for (const std::string name : {"opaque", "round", "fig9b"})
    benchmark::RegisterBenchmark(("rows/" + name).c_str(), time_rows,
                                 scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml"))
        ->MeasureProcessCPUTime() // rows are drawn on a thread of their own
        ->Unit(benchmark::kMillisecond);
}

} // namespace halftone::micro
