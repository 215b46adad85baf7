#include <halftone/render/render.h>

#include <halftone/render/quantise.h>
#include <halftone/shadow/lights.h>

#include "row_source.h"
#include "rows.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace halftone::render {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int thread_count(int asked, int rows) {
  const int available =
      asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return std::min(available, rows);
}

std::unique_ptr<RowSource> row_source(const scene::World& world, const Settings& settings, int threads) {
  switch (settings.mode) {
  case Mode::full:
    return sampled_rows(world, settings.mode, settings.samples.value_or(4), threads);
  case Mode::reference:
    return sampled_rows(world, settings.mode, settings.samples.value_or(16), threads);
  case Mode::local:
  case Mode::scanline:
    break;
  }
  if (settings.lines) return scanned_rows(world, settings, threads);
  return exact_rows(world, settings, threads);
}

} // namespace

std::string_view name(Mode mode) {
  switch (mode) {
  case Mode::local:
    return "local";
  case Mode::scanline:
    return "scanline";
  case Mode::full:
    return "full";
  case Mode::reference:
    return "reference";
  }
  return {};
}

std::string_view name(Show show) {
  switch (show) {
  case Show::signatures:
    return "signatures";
  case Show::intervals:
    return "intervals";
  case Show::samples:
    return "samples";
  case Show::cost:
    return "cost";
  }
  return {};
}

Statistics render(const scene::Scene& scene, const Settings& settings,
                  const std::function<void(const Row&)>& sink, std::stop_token stop) {
  Statistics statistics;
  statistics.mode = settings.mode;
  statistics.threads = thread_count(settings.threads, scene.image.height);
  const bool by_scan = settings.mode == Mode::local || settings.mode == Mode::scanline;
  statistics.simd = by_scan ? settings.simd : core::Simd::baseline;

  const auto prepared_from = Clock::now();
  const bool faceted = settings.mode == Mode::scanline;
  scene::World world = scene::make_world(faceted ? scene::scanline_scene(scene) : scene);
  if (by_scan) {
    std::vector<scene::Light> lights = shadow::reaching_lights(world);
    statistics.skipped.lights = world.lights.size() - lights.size();
    world.lights = std::move(lights);
  }
  const auto source = row_source(world, settings, statistics.threads);
  statistics.prepare_seconds = seconds_since(prepared_from);

  const auto drawn_from = Clock::now();
  const Quantiser quantise(scene.image);
  std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(scene.image.width));
  const auto deliver = [&](int y, const DrawnRow& row) {
    if (row.shown.empty()) quantise(row.radiance, rgb);
    sink({y, row.radiance, row.shown.empty() ? rgb : row.shown});
  };
  for_each_row(*source, scene.image.height, statistics.threads, deliver, stop);
  statistics.render_seconds = seconds_since(drawn_from);
  statistics.objects = scene.objects.size();
  statistics.prepared_bytes = scene::memory_of(world);
  source->report(statistics);
  return statistics;
}

} // namespace halftone::render
