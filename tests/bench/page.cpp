// The report as one page of HTML, with the plots and pictures beside it.

#include "report.h"

#include "gnuplot.h"

#include <halftone/png/compare.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace halftone::bench {

namespace {

namespace fs = std::filesystem;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else
      result += c;
  }
  return result;
}

std::string number(const std::optional<double>& value) {
  if (!value) return "–";
  std::ostringstream text;
  text << std::setprecision(3) << *value;
  return text.str();
}

std::string picture_name(const SceneResult& scene, const std::string& what) {
  return scene.scene + "-" + what + ".png";
}

void add_figure(std::ostream& page, const std::string& file, const std::string& caption) {
  page << "<figure><img src=\"" << file << "\" alt=\"\"><figcaption>" << escaped(caption)
       << "</figcaption></figure>\n";
}

void add_scene(std::ostream& page, const SceneResult& scene, double equal_error) {
  page << "<h2>" << escaped(scene.scene) << "</h2>\n<p>Exact picture: " << escaped(scene.exact.origin)
       << ".</p>\n";
  page << "<img class=\"plot\" src=\"" << scene.scene << ".svg\" alt=\"error against time\">\n";
  page << "<table><tr><th></th><th>seconds to " << equal_error
       << " level</th><th>times Halftone by area</th><th>slope</th><th>limit against exact</th></tr>\n";
  const std::vector<Ratio> all = ratios(scene, equal_error);
  for (std::size_t c = 0; c < scene.series.size(); ++c)
    page << "<tr><td>" << escaped(scene.series[c].title) << "</td><td>" << number(all[c].seconds)
         << "</td><td>" << number(all[c].times_ours) << "</td><td>" << number(slope(scene.series[c].points()))
         << "</td><td>" << number(scene.series[c].limit) << "</td></tr>\n";
  page << "</table>\n<div>";
  add_figure(page, picture_name(scene, "exact"), "exact");
  for (const Series& series : scene.series) {
    const std::size_t shown = shown_setting(series, equal_error);
    add_figure(page, picture_name(scene, series.contender),
               series.title + ", " + series.measured[shown].setting);
    add_figure(page, picture_name(scene, series.contender + "-difference"), "its difference from exact, × 8");
  }
  page << "</div>\n<details><summary>All "
          "settings</summary><table><tr><th></th><th>setting</th><th>seconds</th>"
          "<th>error</th><th>against exact</th><th>runs</th></tr>\n";
  for (const Series& series : scene.series)
    for (const Measured& each : series.measured)
      page << "<tr><td>" << escaped(series.title) << "</td><td>" << escaped(each.setting) << "</td><td>"
           << number(each.seconds) << "</td><td>" << number(each.error) << "</td><td>"
           << number(each.exact_error) << "</td><td>" << each.runs << "</td></tr>\n";
  page << "</table></details>\n";
}

} // namespace

std::size_t shown_setting(const Series& series, double equal_error) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < series.measured.size(); ++i) {
    const Measured &a = series.measured[i], &b = series.measured[best];
    const bool good = a.error <= equal_error, best_is_good = b.error <= equal_error;
    if (good != best_is_good ? good : (good ? a.seconds < b.seconds : a.error < b.error)) best = i;
  }
  return best;
}

std::string html_of(const Report& report) {
  std::ostringstream page;
  page
      << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Halftone: run time against "
         "error</title>\n<style>body{font:16px/1.5 sans-serif;max-width:70em;margin:2em auto;padding:0 "
         "1em}table{border-collapse:collapse}td,th{padding:.2em .8em;border-bottom:1px solid "
         "#ccc;text-align:right}td:first-child{text-align:left}figure{display:inline-block;margin:.5em;width:"
         "320px;"
         "vertical-align:top}figure img{width:100%}.plot{max-width:100%}</style></head><body>\n"
         "<h1>Run time against error</h1>\n<p>Wall time from the parsed scene to the last row, "
      << report.threads << " threads, the least of " << report.repetitions
      << " interleaved runs (one where a run takes over two seconds). Errors are root mean squares in 8-bit "
         "levels: "
         "ours against the exact picture, the others' against their own converged picture. "
      << report.load << " processes were running when it began; compare nothing but ratios.</p>\n";
  if (!report.missing.empty()) {
    page << "<p>Left out:</p><ul>";
    for (const std::string& line : report.missing) page << "<li>" << escaped(line) << "</li>";
    page << "</ul>\n";
  }
  for (const SceneResult& scene : report.scenes) add_scene(page, scene, report.equal_error);
  page << "</body></html>\n";
  return page.str();
}

void write_pictures(const Report& report, const fs::path& folder) {
  for (const SceneResult& scene : report.scenes) {
    const png::Picture exact = rounded(scene.exact.levels);
    png::write(folder / picture_name(scene, "exact"), exact, png::Encoding::srgb);
    for (const Series& series : scene.series) {
      const png::Picture shown = rounded(series.pictures[shown_setting(series, report.equal_error)]);
      png::write(folder / picture_name(scene, series.contender), shown, png::Encoding::srgb);
      png::write(folder / picture_name(scene, series.contender + "-difference"),
                 png::difference_picture(shown, exact), png::Encoding::srgb);
    }
  }
}

std::optional<std::string> plot(const Report& report, const fs::path& folder) {
  for (const SceneResult& scene : report.scenes) {
    std::ostringstream variables;
    variables << "table='times.csv'; scene='" << scene.scene << "'; at=" << report.equal_error << "; ";
    if (const auto problem = gnuplot(folder, "plot.gp", variables.str())) return problem;
  }
  return std::nullopt;
}

} // namespace halftone::bench
