#include "growth.h"

#include "fit.h"

#include <halftone/render/render.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace halftone::bench {

namespace {

double processor_of(const Grown& run) { return run.processor_seconds; }
double wall_of(const Grown& run) { return run.prepare_seconds + run.render_seconds; }
double comparisons_of(const Grown& run) { return static_cast<double>(run.comparisons); }
double bytes_an_object(const Grown& run) { return static_cast<double>(run.prepared_bytes) / run.objects; }

} // namespace

std::string_view name(FieldKind kind) {
  switch (kind) {
  case FieldKind::round:
    return "round";
  case FieldKind::flat:
    return "flat";
  case FieldKind::mixed:
    return "mixed";
  }
  return {};
}

Grown grow(const Field& field, int threads) {
  const scene::Scene scene = make_field(field);
  const std::clock_t before = std::clock();
  const render::Statistics statistics =
      render::render(scene, {.threads = threads}, [](const render::Row&) {});
  const double processor = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  return {field.objects, statistics.prepare_seconds, statistics.render_seconds,
          processor,     statistics.comparisons,     statistics.prepared_bytes};
}

std::optional<double> exponent(const std::vector<Grown>& runs,
                               const std::function<double(const Grown&)>& value) {
  std::vector<Sighting> sightings;
  for (const Grown& run : runs) sightings.push_back({static_cast<double>(run.objects), value(run)});
  return exponent(sightings);
}

std::string text_of(const std::vector<Growth>& all) {
  std::ostringstream text;
  for (const Growth& growth : all) {
    text << name(growth.kind) << '\n'
         << "   objects    prepare       rows  processor  comparisons  bytes an object\n";
    for (const Grown& run : growth.runs)
      text << std::setw(10) << run.objects << std::fixed << std::setprecision(3) << std::setw(9)
           << run.prepare_seconds << " s" << std::setw(9) << run.render_seconds << " s" << std::setw(9)
           << run.processor_seconds << " s" << std::setw(13) << run.comparisons << std::setprecision(0)
           << std::setw(17) << bytes_an_object(run) << '\n'
           << std::defaultfloat;
    if (const auto fitted = exponent(growth.runs, processor_of))
      text << std::setprecision(3) << "  processor time grows as n^" << *fitted << ", wall time as n^"
           << *exponent(growth.runs, wall_of) << ", comparisons as n^"
           << *exponent(growth.runs, comparisons_of) << "\n\n";
  }
  return text.str();
}

std::string csv_of(const std::vector<Growth>& all) {
  std::ostringstream text;
  text << "field,objects,prepare_seconds,render_seconds,processor_seconds,comparisons,bytes_an_object\n";
  for (const Growth& growth : all)
    for (const Grown& run : growth.runs)
      text << std::setprecision(6) << name(growth.kind) << ',' << run.objects << ',' << run.prepare_seconds
           << ',' << run.render_seconds << ',' << run.processor_seconds << ',' << run.comparisons << ','
           << std::llround(bytes_an_object(run)) << '\n';
  return text.str();
}

std::string json_of(const std::vector<Growth>& all) {
  using Json = nlohmann::ordered_json;
  Json fields = Json::array();
  for (const Growth& growth : all) {
    Json runs = Json::array();
    for (const Grown& run : growth.runs)
      runs.push_back({{"objects", run.objects},
                      {"prepare_seconds", run.prepare_seconds},
                      {"render_seconds", run.render_seconds},
                      {"processor_seconds", run.processor_seconds},
                      {"comparisons", run.comparisons},
                      {"bytes_an_object", bytes_an_object(run)}});
    const auto fitted = [&](const auto& value) {
      const auto found = exponent(growth.runs, value);
      return found ? Json(*found) : Json();
    };
    fields.push_back({{"field", name(growth.kind)},
                      {"processor_exponent", fitted(processor_of)},
                      {"wall_exponent", fitted(wall_of)},
                      {"comparisons_exponent", fitted(comparisons_of)},
                      {"runs", runs}});
  }
  return Json({{"fields", fields}}).dump(2) + "\n";
}

} // namespace halftone::bench
