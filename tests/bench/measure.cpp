#include "measure.h"

#include "ours.h"

#include <halftone/convert/toml.h>

#include <algorithm>
#include <limits>

namespace halftone::bench {

namespace {

namespace fs = std::filesystem;

/// What takes minutes is kept for the next run, under a name that changes with the scene.
template<typename Draw>
Levels kept(const Subject& subject, const std::string& what, const Draw& draw) {
  const std::size_t scene = std::hash<std::string>()(convert::toml(subject.scene));
  const fs::path file = subject.folder / ("kept-" + what + "-" + std::to_string(scene) + ".levels");
  if (fs::exists(file)) return read_levels(file);
  const Levels levels = draw();
  write_levels(file, levels);
  return levels;
}

double exact_error(const Levels& levels, const Exact& exact) {
  return rmse(exact.is_rounded ? unrounded(rounded(levels)) : levels, exact.levels);
}

/// Draws every setting once more, where that is due.
void run_once(const Subject& subject, Contender& contender, const Effort& effort, Series& series,
              const Progress& progress) {
  const std::vector<std::string> settings = contender.settings();
  const bool first = series.measured.empty();
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (first) {
      if (i > 0 && series.measured.back().seconds > effort.longest) return;
      series.measured.push_back({settings[i], std::numeric_limits<double>::infinity(), 0, 0, 0});
    } else if (i == series.measured.size()) {
      return;
    }
    Measured& measured = series.measured[i];
    if (!first && measured.seconds > effort.long_run) continue;
    progress(subject.name + ", " + contender.name() + ", " + settings[i]);
    Drawn drawn = contender.draw(subject, i);
    measured.seconds = std::min(measured.seconds, drawn.seconds);
    ++measured.runs;
    if (first) series.pictures.push_back(std::move(drawn.levels));
  }
}

} // namespace

std::vector<Point> Series::points() const {
  std::vector<Point> all;
  for (const Measured& each : measured) all.push_back({each.seconds, each.error});
  return all;
}

const Series* SceneResult::find(const std::string& contender) const {
  for (const Series& each : series)
    if (each.contender == contender) return &each;
  return nullptr;
}

Exact exact_picture(const Subject& subject, const fs::path& golden, int threads, const Progress& progress) {
  if (fs::exists(golden)) return {unrounded(png::read(golden)), true, "another program's, in tests/golden"};
  constexpr int samples = 24;
  progress(subject.name + ", the exact picture by mode reference");
  Levels levels = kept(subject, "exact", [&] {
    return rendered(subject.scene, {.mode = render::Mode::reference, .samples = samples, .threads = threads})
        .levels;
  });
  return {std::move(levels), false, "our mode reference, 24 x 24 samples a pixel"};
}

SceneResult measure(const Subject& subject, const Exact& exact, const Contenders& contenders,
                    const Effort& effort, const Progress& progress) {
  SceneResult result{subject.name, exact, {}};
  for (const auto& contender : contenders)
    result.series.push_back({contender->name(), contender->title(), {}, std::nullopt, {}});
  for (int repetition = 0; repetition < effort.repetitions; ++repetition)
    for (std::size_t c = 0; c < contenders.size(); ++c)
      run_once(subject, *contenders[c], effort, result.series[c], progress);

  // The two methods of POV-Ray converge to one picture, which is kept under the first word of their name.
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    Series& series = result.series[c];
    Levels converged;
    if (!contenders[c]->judged_by_exact()) {
      progress(subject.name + ", " + series.contender + ", converged");
      converged = kept(subject, series.contender.substr(0, series.contender.find('-')),
                       [&] { return contenders[c]->converged(subject); });
      series.limit = exact_error(converged, exact);
    }
    for (std::size_t i = 0; i < series.measured.size(); ++i) {
      Measured& measured = series.measured[i];
      measured.exact_error = exact_error(series.pictures[i], exact);
      measured.error = series.limit ? rmse(series.pictures[i], converged) : measured.exact_error;
    }
  }
  return result;
}

} // namespace halftone::bench
