// Halftone itself: rows by area over the quality, the paper's virtual scanlines over their number, and mode
// full, the conventional method, over its samples.

#include "ours.h"

#include "contender.h"

#include <stdexcept>
#include <vector>

namespace halftone::bench {

namespace {

struct NamedSettings {
  std::string name;
  render::Settings settings;
};

class Ours : public Contender {
public:
  Ours(std::string name, std::string title, std::vector<NamedSettings> all)
      : name_(std::move(name)),
        title_(std::move(title)),
        all_(std::move(all)) {}

  std::string name() const override { return name_; }
  std::string title() const override { return title_; }
  std::vector<std::string> settings() const override {
    std::vector<std::string> names;
    for (const NamedSettings& each : all_) names.push_back(each.name);
    return names;
  }

  Drawn draw(const Subject& subject, std::size_t setting) override {
    Rendered picture = rendered(subject.scene, all_[setting].settings);
    return {std::move(picture.levels), picture.seconds()};
  }

  Levels converged(const Subject&) override { throw std::logic_error("judged by the exact picture"); }
  bool judged_by_exact() const override { return true; }

private:
  std::string name_;
  std::string title_;
  std::vector<NamedSettings> all_;
};

} // namespace

Rendered rendered(const scene::Scene& scene, const render::Settings& settings) {
  Rendered result;
  std::vector<core::Color> radiance;
  result.statistics = render::render(scene, settings, [&](const render::Row& row) {
    radiance.insert(radiance.end(), row.radiance.begin(), row.radiance.end());
  });
  result.levels = levels_of(radiance, scene.image);
  return result;
}

void add_ours(Contenders& contenders, int threads) {
  std::vector<NamedSettings> areas, lines, full;
  for (const char* quality : {"8", "4", "2", "1", "0.5", "0.25", "0.1", "0.05"})
    areas.push_back({std::string("quality ") + quality, {.threads = threads, .quality = std::stod(quality)}});
  for (const int n : {1, 2, 4, 8, 16, 32, 64})
    lines.push_back({std::to_string(n) + (n == 1 ? " line" : " lines"), {.threads = threads, .lines = n}});
  for (const int n : {1, 2, 4, 6, 8})
    full.push_back({std::to_string(n) + " x " + std::to_string(n),
                    {.mode = render::Mode::full, .samples = n, .threads = threads}});
  contenders.push_back(std::make_unique<Ours>("areas", "Halftone, rows by area", std::move(areas)));
  contenders.push_back(std::make_unique<Ours>("lines", "Halftone, virtual scanlines", std::move(lines)));
  contenders.push_back(std::make_unique<Ours>("full", "Halftone, every pixel traced", std::move(full)));
}

} // namespace halftone::bench
