#include "report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace halftone::bench {

namespace {

bool is_ours(const Series& series) { return !series.limit; }

nlohmann::ordered_json json_of(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

std::string text_of(const std::optional<double>& number, const char* unit) {
  if (!number) return "not reached";
  std::ostringstream text;
  text << std::setprecision(3) << *number << unit;
  return text.str();
}

/// In levels. A contender whose converged picture is farther from the exact one, as where glass touches,
/// converges to noise of its own, and a ratio would be won by forfeit.
constexpr double most_limit = 10;

} // namespace

std::vector<Ratio> ratios(const SceneResult& scene, double equal_error) {
  std::optional<double> ours;
  if (const Series* areas = scene.find("areas")) ours = seconds_at(areas->points(), equal_error);
  std::vector<Ratio> all;
  for (const Series& series : scene.series) {
    Ratio ratio{series.contender, seconds_at(series.points(), equal_error), std::nullopt};
    const bool is_noise = series.limit && *series.limit > most_limit;
    if (ours && ratio.seconds && !is_noise) ratio.times_ours = *ratio.seconds / *ours;
    all.push_back(ratio);
  }
  return all;
}

std::optional<Ratio> best_other(const SceneResult& scene, double equal_error) {
  std::optional<Ratio> best;
  for (const Ratio& ratio : ratios(scene, equal_error))
    if (!is_ours(*scene.find(ratio.contender)) && ratio.times_ours &&
        (!best || *ratio.times_ours < *best->times_ours))
      best = ratio;
  return best;
}

std::string text_of(const Report& report) {
  std::ostringstream text;
  for (const SceneResult& scene : report.scenes) {
    text << scene.scene << "; exact picture: " << scene.exact.origin << '\n';
    for (const Series& series : scene.series) {
      text << "  " << series.title;
      if (series.limit)
        text << "; its limit is off the exact picture by " << std::setprecision(3) << *series.limit;
      text << '\n';
      for (const Measured& each : series.measured)
        text << "    " << std::left << std::setw(34) << each.setting << std::right << std::fixed
             << std::setprecision(4) << std::setw(10) << each.seconds << " s" << std::setprecision(3)
             << std::setw(9) << each.error << std::setw(9) << each.exact_error << '\n'
             << std::defaultfloat;
      text << "    at " << report.equal_error
           << " level: " << text_of(seconds_at(series.points(), report.equal_error), " s") << "; slope "
           << text_of(slope(series.points()), "") << '\n';
    }
    const auto best = best_other(scene, report.equal_error);
    text << "  the best other takes "
         << (best ? text_of(best->times_ours, " times as long as Halftone by area: ") + best->contender
                  : std::string("no time to compare: it does not get there, or its limit is noise"))
         << "\n\n";
  }
  for (const std::string& line : report.missing) text << "left out: " << line << '\n';
  return text.str();
}

std::string csv_of(const Report& report) {
  std::ostringstream text;
  text << "scene,contender,setting,seconds,error,exact_error,runs\n" << std::setprecision(6);
  for (const SceneResult& scene : report.scenes)
    for (const Series& series : scene.series)
      for (const Measured& each : series.measured)
        text << scene.scene << ',' << series.contender << ",\"" << each.setting << "\"," << each.seconds
             << ',' << each.error << ',' << each.exact_error << ',' << each.runs << '\n';
  return text.str();
}

std::string json_of(const Report& report) {
  using Json = nlohmann::ordered_json;
  Json scenes = Json::array();
  for (const SceneResult& scene : report.scenes) {
    Json contenders = Json::array();
    const std::vector<Ratio> all = ratios(scene, report.equal_error);
    for (std::size_t c = 0; c < scene.series.size(); ++c) {
      const Series& series = scene.series[c];
      Json settings = Json::array();
      for (const Measured& each : series.measured)
        settings.push_back({{"setting", each.setting},
                            {"seconds", each.seconds},
                            {"error", each.error},
                            {"exact_error", each.exact_error},
                            {"runs", each.runs}});
      contenders.push_back({{"name", series.contender},
                            {"title", series.title},
                            {"limit", json_of(series.limit)},
                            {"seconds_at_equal_error", json_of(all[c].seconds)},
                            {"times_ours", json_of(all[c].times_ours)},
                            {"slope", json_of(slope(series.points()))},
                            {"settings", settings}});
    }
    const auto best = best_other(scene, report.equal_error);
    scenes.push_back({{"name", scene.scene},
                      {"exact", scene.exact.origin},
                      {"best_other", best ? Json(best->contender) : Json()},
                      {"best_other_times_ours", best ? json_of(best->times_ours) : Json()},
                      {"contenders", contenders}});
  }
  const Json all = {{"threads", report.threads},         {"repetitions", report.repetitions},
                    {"equal_error", report.equal_error}, {"load", report.load},
                    {"left_out", report.missing},        {"scenes", scenes}};
  return all.dump(2) + "\n";
}

} // namespace halftone::bench
