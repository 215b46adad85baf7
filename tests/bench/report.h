#pragma once
// Results as text, CSV, JSON, pictures and a page.

#include "measure.h"

namespace halftone::bench {

struct Report {
  std::vector<SceneResult> scenes;
  std::vector<std::string> missing; ///< a line for each contender or tool that was left out
  int threads = 0;
  int repetitions = 0;
  double equal_error = 0; ///< in levels, where times are compared
  double load = 0;        ///< processes that were running or waiting when the run began
};

/// The time to the error of comparison of each contender, as a multiple of `areas`.
struct Ratio {
  std::string contender;
  std::optional<double> seconds;
  std::optional<double> times_ours; ///< nothing where either does not get there, or to noise
};
std::vector<Ratio> ratios(const SceneResult& scene, double equal_error);

/// The least of the others' (Embree's, POV-Ray's) ratios; nothing where none gets there.
std::optional<Ratio> best_other(const SceneResult& scene, double equal_error);

std::string text_of(const Report& report);
std::string csv_of(const Report& report);
std::string json_of(const Report& report);
std::string html_of(const Report& report);

/// The setting whose picture is shown: the fastest with at most the error of comparison, else the most
/// accurate.
std::size_t shown_setting(const Series& series, double equal_error);

/// PNG files of the exact pictures, those shown and their differences from exact, as html_of names them.
void write_pictures(const Report& report, const std::filesystem::path& folder);

/// SCENE.svg and SCENE.png by gnuplot, from times.csv in the folder; a line for `missing` where it is not
/// there.
std::optional<std::string> plot(const Report& report, const std::filesystem::path& folder);

} // namespace halftone::bench
