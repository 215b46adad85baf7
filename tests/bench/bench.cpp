// halftone-bench: run time against error, beside other programs (docs/performance.md).

#include "costs.h"
#include "growth.h"
#include "report.h"
#include "survival.h"

#include <halftone/file/write.h>
#include <halftone/scene/read.h>
#include <halftone/terminal/exit_code.h>
#include <halftone/terminal/limits.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <span>

using namespace halftone;
using namespace halftone::bench;
using terminal::ArgumentError;
using terminal::ExitCode;
namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<std::string> scenes{"fig9a", "fig9a-gaps", "fig9b", "opaque", "round"};
  std::vector<std::string> contenders;
  Effort effort;
  int threads = 2;
  double equal_error = 0.35;
  bool stability = false;
  bool costs = false;
  std::string folder = "bench";
  std::vector<int> growth; ///< numbers of objects; then nothing else is measured
};

fs::path scenes() { return HALFTONE_SOURCE_DIR "/scenes"; }
/// Exact pictures by another program, some scenes'.
fs::path golden() { return HALFTONE_SOURCE_DIR "/tests/golden"; }

/// A name in scenes/, or a file of the user's own.
Subject subject_of(const std::string& scene, const fs::path& folder) {
  fs::path file = scene;
  if (file.extension() != ".toml") file = scenes() / (scene + ".toml");
  Subject subject{file.stem().string(), scene::read_scene(file), folder / "work" / file.stem()};
  if (subject.name.find_first_of("',\" ") != std::string::npos)
    throw ArgumentError("--scenes: names with spaces, commas and quotes are not taken: " + subject.name);
  fs::create_directories(subject.folder);
  return subject;
}

void keep_only(const std::vector<std::string>& wanted, Contenders& all,
               const std::vector<std::string>& missing) {
  for (const std::string& name : wanted)
    if (std::none_of(all.begin(), all.end(), [&](const auto& each) { return each->name() == name; })) {
      std::vector<std::string> names;
      for (const auto& each : all) names.push_back(each->name());
      std::string problem =
          "--contenders: expected " + terminal::alternatives(names) + ", found \"" + name + "\"";
      for (const std::string& line : missing) problem += "; " + line;
      throw ArgumentError(problem);
    }
  if (!wanted.empty())
    std::erase_if(all, [&](const auto& each) {
      return std::find(wanted.begin(), wanted.end(), each->name()) == wanted.end();
    });
}

void write(const fs::path& file, const std::string& text) {
  file::write_whole(file, std::as_bytes(std::span(text)));
}

void tell(const std::string& what) { std::cerr << what << '\n'; }

void measure_growth(const Options& options, const fs::path& folder) {
  std::vector<Growth> all;
  for (const FieldKind kind : {FieldKind::flat, FieldKind::round, FieldKind::mixed}) {
    Growth& growth = all.emplace_back();
    growth.kind = kind;
    for (const int objects : options.growth) {
      tell(std::string(name(kind)) + ", " + std::to_string(objects) + " objects");
      growth.runs.push_back(grow({.kind = kind, .objects = objects}, options.threads));
      write(folder / "growth.csv", csv_of(all));
    }
  }
  write(folder / "growth.json", json_of(all));
  std::cout << text_of(all);
}

/// Error over time.
void measure_times(const Options& options, const std::vector<Subject>& subjects, const fs::path& folder) {
  Report report;
  report.threads = options.threads;
  report.repetitions = options.effort.repetitions;
  report.equal_error = options.equal_error;
  double load = 0;
  if (getloadavg(&load, 1) == 1) report.load = load;
  Contenders contenders = all_contenders(options.threads, report.missing);
  keep_only(options.contenders, contenders, report.missing);

  for (const Subject& subject : subjects) {
    const Exact exact = exact_picture(subject, golden() / (subject.name + ".png"), options.threads, tell);
    report.scenes.push_back(measure(subject, exact, contenders, options.effort, tell));
    write(folder / "times.csv", csv_of(report)); // a long run is worth something before it ends
  }
  if (const auto line = plot(report, folder)) report.missing.push_back(*line);
  write_pictures(report, folder);
  write(folder / "report.json", json_of(report));
  write(folder / "index.html", html_of(report));
  write(folder / "report.txt", text_of(report));
  std::cout << text_of(report);
}

void measure_stability(const Options& options, const std::vector<Subject>& subjects, const fs::path& folder) {
  std::vector<std::string> missing;
  Contenders contenders = all_contenders(options.threads, missing);
  keep_only(options.contenders, contenders, missing);
  Survivals result = survivals(subjects, contenders, golden(), tell);
  result.missing = missing;
  write(folder / "stability.json", json_of(result));
  write(folder / "stability.txt", text_of(result));
  std::cout << text_of(result);
}

void measure_costs(const Options& options, const std::vector<Subject>& subjects, const fs::path& folder) {
  std::vector<CostTable> tables{traced_area_by_number(), traced_area_by_zoom(scenes()),
                                paper_table(scenes(), golden()), threads_table(subjects)};
  for (CostTable& table : tables) time_runs(table, options.effort, tell);
  write(folder / "costs.csv", csv_of(tables));
  write(folder / "costs.json", json_of(tables));
  std::string text = text_of(tables);
  if (const auto problem = plot_costs(folder)) text += "left out: " + *problem + '\n';
  write(folder / "costs.txt", text);
  std::cout << text;
}

ExitCode run(const Options& options) {
  const fs::path folder = options.folder;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw file::WriteError(folder.string() + ": the folder cannot be made: " + error.message());
  file::check_writable(folder / "times.csv");
  std::vector<Subject> subjects;
  for (const std::string& scene : options.scenes) subjects.push_back(subject_of(scene, folder));
  if (!options.growth.empty())
    measure_growth(options, folder);
  else if (options.stability)
    measure_stability(options, subjects, folder);
  else if (options.costs)
    measure_costs(options, subjects, folder);
  else
    measure_times(options, subjects, folder);
  return ExitCode::done;
}

} // namespace

int main(int count, char** arguments) {
  Options options;
  CLI::App program{"Measures run time against error, beside a ray tracer on Embree and POV-Ray 3.7.",
                   "halftone-bench"};
  program.add_option("--scenes", options.scenes, "Names in scenes/, or files")
      ->delimiter(',')
      ->capture_default_str();
  CLI::Option* const contenders =
      program
          .add_option("--contenders", options.contenders,
                      "Of areas, lines, full, embree, povray-1, povray-2; all by default")
          ->delimiter(',');
  program
      .add_option("--repetitions", options.effort.repetitions,
                  "Runs of each setting, of which the least time counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  program.add_option("--threads", options.threads, "Of every contender")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  program
      .add_option("--longest", options.effort.longest,
                  "Seconds: after a setting that takes longer, its contender has no more")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  program.add_option("--at", options.equal_error, "The error, in levels, at which times are compared")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI::Option* const stability = program.add_flag(
      "--stability", options.stability,
      "Instead: how far pictures of the scenes scaled and moved are from those of the scenes as "
      "they are, in stability.txt and stability.json");
  program
      .add_flag("--costs", options.costs,
                "Instead: Halftone alone, time over what is traced, the paper's own measurements, and the "
                "scenes with one thread and with two, in costs.txt, costs.json, costs.csv and a plot")
      ->excludes(stability)
      ->excludes(contenders);
  program
      .add_option("--growth", options.growth,
                  "Numbers of objects: draws generated fields of so many instead, and writes growth.csv and "
                  "growth.json")
      ->delimiter(',')
      ->check(CLI::Range(1, 10'000'000));
  program
      .add_option("-o,--output", options.folder,
                  "Folder for index.html, report.txt, report.json, times.csv, plots and pictures")
      ->capture_default_str();
  program.footer("Example:\n  halftone-bench --scenes opaque,round --contenders areas,embree -o bench");
  try {
    program.parse(count, arguments);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    std::cerr << "halftone-bench: " << error.what() << '\n';
    return static_cast<int>(ExitCode::bad_arguments);
  }
  try {
    return static_cast<int>(terminal::guarded(
        "halftone-bench", [&] { return run(options); }, std::cerr));
  } catch (const std::runtime_error& error) { // of a contender
    std::cerr << "halftone-bench: " << error.what() << '\n';
    return static_cast<int>(ExitCode::no);
  }
}
