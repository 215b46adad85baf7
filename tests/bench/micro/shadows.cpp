// Where shadows may fall, for every face that is drawn by scanlines and every light, as a frame finds them
// once. An item is a face under a light.

#include "micro.h"

#include <halftone/scan/frame.h>
#include <halftone/scene/read.h>
#include <halftone/shadow/shadows.h>

#include <benchmark/benchmark.h>

#include <string>

namespace halftone::micro {

namespace {

void time_shadows(benchmark::State& state, const scene::Scene& scene) {
  const scene::World world = scene::make_world(scene);
  const scan::Frame frame(world);
  const int lights = static_cast<int>(world.lights.size());
  std::size_t regions = 0;
  for (auto _ : state) {
    shadow::Shadows shadows(world, frame.screen, frame.hulls, frame.casters);
    regions = 0;
    for (const scan::ScreenFace& face : frame.faces)
      for (int light = 0; light < lights; ++light) regions += shadows.on(face.body, face.face, light).size();
    benchmark::DoNotOptimize(regions);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frame.faces.size()) * lights);
  state.counters["regions"] = static_cast<double>(regions);
}

} // namespace

void add_shadows() {
  for (const std::string name : {"opaque", "round", "fig9b"})
    benchmark::RegisterBenchmark(("shadows/" + name).c_str(), time_shadows,
                                 scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml"));
}

} // namespace halftone::micro
