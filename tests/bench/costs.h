#pragma once
// Whether cost follows need: Halftone alone, its time against what a scene needs.

#include "measure.h"

#include <halftone/render/render.h>

namespace halftone::bench {

/// One picture to be timed.
struct Run {
  std::string group;   ///< runs whose times are compared with that of its first one
  std::string setting; ///< a few words
  scene::Scene content;
  render::Settings settings;
  std::optional<std::filesystem::path> exact; ///< another program's picture of it, where there is one

  double seconds = 0; ///< the least, from the parsed scene to the last row
  int runs = 0;
  std::uint64_t traced_pixels = 0;
  std::optional<double> error; ///< RMSE against that picture, in levels; rounded as it is
};

/// Runs that are timed in turn, and only to be compared with each other.
struct CostTable {
  std::string name; ///< a word
  std::string title;
  bool over_area = false; ///< a straight line is put through seconds over traced pixels
  std::vector<Run> runs;
};

/// Glass prisms take the place of opaque ones, two at a time, in one picture: area, and the boundaries seen
/// in it, grow in the same steps. And figure 9 (a) by the field of view, where boundaries grow as the square
/// root of the area: it is at them that rows by area cast most of their rays. One thread.
CostTable traced_area_by_number();
CostTable traced_area_by_zoom(const std::filesystem::path& scenes);

/// The paper's own measurements: scanlines alone, figure 9 (b) with its glass opaque, local and full ray
/// tracing; with 8 virtual scanlines, full at about the same error, and by area. One thread.
CostTable paper_table(const std::filesystem::path& scenes, const std::filesystem::path& golden);

/// Every subject with two threads and with one.
CostTable threads_table(const std::vector<Subject>& subjects);

/// Fills in what is measured; every repetition does each run once.
void time_runs(CostTable& table, const Effort& effort, const Progress& progress);

/// costs.svg and costs.png by gnuplot, from costs.csv in the folder; what went wrong, if anything.
std::optional<std::string> plot_costs(const std::filesystem::path& folder);

std::string text_of(const std::vector<CostTable>& tables);
std::string csv_of(const std::vector<CostTable>& tables);
std::string json_of(const std::vector<CostTable>& tables);

} // namespace halftone::bench
