// Costs as text, CSV, JSON and a plot.

#include "costs.h"
#include "fit.h"
#include "gnuplot.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>

namespace halftone::bench {

namespace {

/// Seconds over traced pixels.
Fit fit_of(const CostTable& table) {
  std::vector<Sighting> sightings;
  for (const Run& run : table.runs)
    sightings.push_back({static_cast<double>(run.traced_pixels), run.seconds});
  return fit(sightings);
}

/// Of the time of the first run in its group.
double ratio(const CostTable& table, const Run& run) {
  for (const Run& each : table.runs)
    if (each.group == run.group) return run.seconds / each.seconds;
  return 1;
}

std::string text_of(const CostTable& table) {
  std::ostringstream text;
  text << table.title << "\n\n| | | traced pixels | seconds | ratio | RMSE |\n|---|---|---|---|---|---|\n";
  for (const Run& run : table.runs) {
    text << "| " << run.group << " | " << run.setting << " | " << run.traced_pixels << " | "
         << std::setprecision(3) << run.seconds << " | " << ratio(table, run) << " | ";
    if (run.error) text << *run.error;
    text << " |\n";
  }
  if (table.over_area) {
    const Fit line = fit_of(table);
    text << "\nseconds = " << line.at_zero << " + " << line.slope * 1e6
         << "e-6 a traced pixel; R^2 = " << std::setprecision(4) << line.r_squared << '\n';
  }
  return text.str();
}

nlohmann::ordered_json json_of(const CostTable& table) {
  using Json = nlohmann::ordered_json;
  Json runs = Json::array();
  for (const Run& run : table.runs)
    runs.push_back({{"group", run.group},
                    {"setting", run.setting},
                    {"threads", run.settings.threads},
                    {"traced_pixels", run.traced_pixels},
                    {"seconds", run.seconds},
                    {"ratio", ratio(table, run)},
                    {"runs", run.runs},
                    {"rmse", run.error ? Json(*run.error) : Json()}});
  Json result = {{"name", table.name}, {"title", table.title}, {"runs", runs}};
  if (table.over_area) {
    const Fit line = fit_of(table);
    result["line"] = {{"seconds_at_zero", line.at_zero},
                      {"seconds_a_traced_pixel", line.slope},
                      {"r_squared", line.r_squared}};
  }
  return result;
}

} // namespace

std::string text_of(const std::vector<CostTable>& tables) {
  std::string text;
  for (const CostTable& table : tables) text += text_of(table) + '\n';
  return text;
}

std::string csv_of(const std::vector<CostTable>& tables) {
  std::ostringstream text;
  text << "table,group,setting,threads,traced_pixels,seconds,ratio,runs,rmse\n" << std::setprecision(6);
  for (const CostTable& table : tables)
    for (const Run& run : table.runs) {
      text << table.name << ",\"" << run.group << "\",\"" << run.setting << "\"," << run.settings.threads
           << ',' << run.traced_pixels << ',' << run.seconds << ',' << ratio(table, run) << ',' << run.runs
           << ',';
      if (run.error) text << *run.error;
      text << '\n';
    }
  return text.str();
}

std::string json_of(const std::vector<CostTable>& tables) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const CostTable& table : tables) all.push_back(json_of(table));
  return nlohmann::ordered_json{{"tables", all}}.dump(2) + "\n";
}

std::optional<std::string> plot_costs(const std::filesystem::path& folder) {
  return gnuplot(folder, "costs.gp", "");
}

} // namespace halftone::bench
