#include "costs.h"

#include "ours.h"

#include <halftone/scene/read.h>

#include <algorithm>
#include <limits>

namespace halftone::bench {

namespace {

namespace fs = std::filesystem;

constexpr int prisms_a_side = 4;

/// Seen steeply, so that they hide little of each other. Of the prisms, `glass` many are of glass, scattered
/// over the field.
scene::Scene prisms(int glass) {
  constexpr int count = prisms_a_side * prisms_a_side;
  scene::Scene scene;
  scene.image.width = 320;
  scene.image.height = 240;
  scene.camera = {{3, -9, 13}, {0, 0, 0}, {0, 0, 1}, 34};
  scene.background = {0.3, 0.4, 0.6};
  scene.ambient = core::Color{0.2};
  scene.lights.push_back({{-5, -6, 9}, {0.9, 0.9, 0.85}});
  scene.materials.resize(3);
  scene.materials[0].checker = scene::Checker{{0.25, 0.3, 0.4}, 1.1, 0, 1};
  scene.materials[1].diffuse = {0.55, 0.7, 0.66};
  scene.materials[2].glass = scene::Glass{1.52, {0.1, 0.04, 0.06}};
  scene.materials[2].diffuse = core::black;
  scene.objects.emplace_back().shape = scene::Polygon{{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}}};
  for (int i = 0; i < count; ++i) {
    scene::Object& object = scene.objects.emplace_back();
    object.shape = scene::Prism{{0, 0, 0}, {0, 0, 0.7}, 0.75, 8, 22.5};
    constexpr double spacing = 2, first = -0.5 * spacing * (prisms_a_side - 1);
    object.placement.translate = {first + spacing * (i % prisms_a_side),
                                  first + spacing * (i / prisms_a_side), 0};
    constexpr int stride = 7; // no divisor in common with the count
    object.material = i * stride % count < glass ? 2 : 1;
  }
  return scene;
}

Run run_of(std::string group, std::string setting, scene::Scene content, const render::Settings& settings) {
  Run run;
  run.group = std::move(group);
  run.setting = std::move(setting);
  run.content = std::move(content);
  run.settings = settings;
  return run;
}

void run_once(Run& run) {
  const Rendered picture = rendered(run.content, run.settings);
  run.seconds = run.runs == 0 ? picture.seconds() : std::min(run.seconds, picture.seconds());
  run.traced_pixels = picture.statistics.traced_pixels;
  if (run.exact && run.runs == 0)
    run.error = rmse(unrounded(rounded(picture.levels)), unrounded(png::read(*run.exact)));
  ++run.runs;
}

} // namespace

CostTable traced_area_by_number() {
  CostTable table{"number", "Sixteen prisms, more and more of them glass; one thread", true, {}};
  for (int glass = 0; glass <= prisms_a_side * prisms_a_side; glass += 2)
    table.runs.push_back(
        run_of("prisms", std::to_string(glass) + " of glass", prisms(glass), {.threads = 1}));
  return table;
}

CostTable traced_area_by_zoom(const fs::path& scenes) {
  CostTable table{"zoom", "Figure 9 (a) by the field of view; one thread", true, {}};
  for (const int fov : {100, 80, 60, 50, 40, 30, 25, 20}) {
    scene::Scene scene = scene::read_scene(scenes / "fig9a.toml");
    scene.camera.fov = fov;
    table.runs.push_back(run_of("fig9a", std::to_string(fov) + " degrees", std::move(scene), {.threads = 1}));
  }
  return table;
}

CostTable paper_table(const fs::path& scenes, const fs::path& golden) {
  using render::Mode;
  CostTable table{"paper", "The paper's own measurements; one thread", false, {}};
  const auto add = [&](const std::string& group, const std::string& setting, const std::string& scene,
                       const render::Settings& settings, const std::optional<fs::path>& exact) {
    table.runs.push_back(run_of(group, setting, scene::read_scene(scenes / (scene + ".toml")), settings));
    table.runs.back().exact = exact;
  };
  struct Figure {
    std::string scene;
    int full_samples; ///< with which full has about the error of local with 8 lines
  };
  for (const Figure& figure : {Figure{"fig9a", 6}, Figure{"fig9b", 7}}) {
    const fs::path picture = golden / (figure.scene + ".png"),
                   scanline = golden / "scanline" / (figure.scene + ".png");
    const std::string n = std::to_string(figure.full_samples);
    for (const std::optional<int> lines : {std::optional<int>(8), std::optional<int>()}) {
      const std::string group = figure.scene + (lines ? ", 8 lines" : ", by area");
      add(group, "scanline", figure.scene, {.mode = Mode::scanline, .threads = 1, .lines = lines}, scanline);
      if (figure.scene == "fig9b")
        add(group, "local, glass opaque", "fig9b-opaque", {.threads = 1, .lines = lines}, std::nullopt);
      add(group, "local", figure.scene, {.threads = 1, .lines = lines}, picture);
      if (lines)
        add(group, "full, " + n + " x " + n, figure.scene,
            {.mode = Mode::full, .samples = figure.full_samples, .threads = 1}, picture);
    }
  }
  return table;
}

CostTable threads_table(const std::vector<Subject>& subjects) {
  CostTable table{"threads", "Two threads and one", false, {}};
  for (const Subject& subject : subjects)
    for (const int threads : {2, 1})
      table.runs.push_back(
          run_of(subject.name, threads == 1 ? "1 thread" : "2 threads", subject.scene, {.threads = threads}));
  return table;
}

void time_runs(CostTable& table, const Effort& effort, const Progress& progress) {
  for (int repetition = 0; repetition < effort.repetitions; ++repetition)
    for (Run& run : table.runs) {
      if (run.runs > 0 && run.seconds > effort.long_run) continue;
      progress(table.name + ", " + run.group + ", " + run.setting);
      run_once(run);
    }
}

} // namespace halftone::bench
