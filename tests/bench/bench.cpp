// Run time against error, as comma-separated values: for each scene the exact rows over their qualities and
// the paper's method over its lines, each against the picture of another program in tests/golden. All
// settings are run one after the other, and again, so that a slow minute of the machine is nobody's alone;
// the least time counts.

#include <halftone/png/png.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace halftone;

namespace {

constexpr int rounds = 5;
constexpr double long_run = 2; // seconds

struct Entry {
  std::string method;
  double setting = 0;
  render::Settings settings;
  double seconds = std::numeric_limits<double>::infinity();
  double rmse = 0; ///< in 8-bit levels
  int largest = 0;
};

std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (const double quality : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0})
    all.push_back({"areas", quality, {.quality = quality}});
  for (const int lines : {1, 2, 4, 8, 16, 32, 64})
    all.push_back({"lines", static_cast<double>(lines), {.lines = lines}});
  return all;
}

/// Scene prepared to last row.
void run(const scene::Scene& scene, const png::Picture& wanted, Entry& entry) {
  double sum = 0;
  const auto statistics = render::render(scene, entry.settings, [&](const render::Row& row) {
    for (std::size_t i = 0; i < row.rgb.size(); ++i) {
      const int off = std::abs(row.rgb[i] - wanted.rgb[row.y * row.rgb.size() + i]);
      sum += off * off;
      entry.largest = std::max(entry.largest, off);
    }
  });
  entry.rmse = std::sqrt(sum / static_cast<double>(wanted.rgb.size()));
  entry.seconds = std::min(entry.seconds, statistics.prepare_seconds + statistics.render_seconds);
}

void measure(const std::string& name) {
  const png::Picture wanted = png::read(HALFTONE_SOURCE_DIR "/tests/golden/" + name + ".png");
  const scene::Scene scene = scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml");
  std::vector<Entry> all = entries();
  for (int round = 0; round < rounds; ++round)
    for (Entry& entry : all)
      if (round == 0 || entry.seconds < long_run) run(scene, wanted, entry);
  for (const Entry& entry : all)
    std::cout << name << ',' << entry.method << ',' << entry.setting << ',' << entry.seconds << ','
              << entry.rmse << ',' << entry.largest << std::endl;
}

} // namespace

int main(int count, char** arguments) {
  try {
    std::vector<std::string> names(arguments + 1, arguments + count);
    if (names.empty())
      names = {"fig9a",   "fig9b",  "contact", "nested", "inside",
               "mirrors", "sliver", "cyclic",  "opaque", "round"};
    std::cout << "scene,method,setting,seconds,rmse,largest\n";
    for (const std::string& name : names) measure(name);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "halftone-bench: " << error.what() << '\n';
    return 1;
  }
}
