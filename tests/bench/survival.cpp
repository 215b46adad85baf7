#include "survival.h"

#include "support/transformed.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace halftone::bench {

namespace {

struct Transform {
  const char* name;
  scene::Scene (*apply)(const scene::Scene&);
};

constexpr std::array transforms{
    Transform{"scaled by 1e-4", [](const scene::Scene& scene) { return test::scaled(scene, 1e-4); }},
    Transform{"scaled by 1e7", [](const scene::Scene& scene) { return test::scaled(scene, 1e7); }},
    Transform{"moved by 1e6", [](const scene::Scene& scene) { return test::far_away(scene); }},
};

struct Chosen {
  const char* contender;
  const char* setting;
};

/// Accurate, and done in seconds.
constexpr std::array chosen{
    Chosen{"areas", "quality 0.25"},
    Chosen{"embree", "4 x 4 to 16 x 16, contrast 4"},
    Chosen{"povray-1", "+AM1 +A0.0 +R4"},
    Chosen{"povray-2", "+AM2 +A0.003 +R4"},
};

std::size_t setting_of(const Contender& contender, const std::string& wanted) {
  const std::vector<std::string> all = contender.settings();
  const auto found = std::find(all.begin(), all.end(), wanted);
  if (found == all.end()) throw std::logic_error(contender.name() + " has no setting " + wanted);
  return static_cast<std::size_t>(found - all.begin());
}

Survival survival(const Subject& subject, Contender& contender, const std::string& setting,
                  const std::filesystem::path& golden, const Progress& progress) {
  const std::size_t index = setting_of(contender, setting);
  const auto drawn = [&](const Subject& what, const char* how) {
    progress(subject.name + ", " + contender.name() + ", " + how);
    return contender.draw(what, index).levels;
  };
  Survival result{subject.name, contender.name(), setting, {}, std::nullopt};
  const Levels as_it_is = drawn(subject, "as it is");
  for (const Transform& transform : transforms) {
    const Subject transformed{subject.name, transform.apply(subject.scene), subject.folder};
    result.off.push_back(rmse(drawn(transformed, transform.name), as_it_is));
  }
  const std::filesystem::path exact = golden / (subject.name + ".png");
  if (std::filesystem::exists(exact))
    result.exact = rmse(unrounded(rounded(as_it_is)), unrounded(png::read(exact)));
  return result;
}

std::string text_of(double error) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(error < 10 ? 3 : 1) << error;
  return text.str();
}

} // namespace

Survivals survivals(const std::vector<Subject>& subjects, const Contenders& contenders,
                    const std::filesystem::path& golden, const Progress& progress) {
  Survivals result;
  for (const Transform& transform : transforms) result.transforms.emplace_back(transform.name);
  for (const Subject& subject : subjects)
    for (const Chosen& each : chosen)
      for (const auto& contender : contenders)
        if (contender->name() == each.contender)
          result.all.push_back(survival(subject, *contender, each.setting, golden, progress));
  return result;
}

std::string text_of(const Survivals& survivals) {
  std::ostringstream text;
  text << "| scene | contender | setting |";
  for (const std::string& name : survivals.transforms) text << ' ' << name << " |";
  text << " against exact |\n|---|---|---|";
  for (std::size_t i = 0; i <= survivals.transforms.size(); ++i) text << "---|";
  text << '\n';
  for (const Survival& each : survivals.all) {
    text << "| `" << each.scene << "` | `" << each.contender << "` | " << each.setting << " |";
    for (const double off : each.off) text << ' ' << text_of(off) << " |";
    text << ' ' << (each.exact ? text_of(*each.exact) : "") << " |\n";
  }
  for (const std::string& line : survivals.missing) text << "\nLeft out: " << line << '\n';
  return text.str();
}

std::string json_of(const Survivals& survivals) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const Survival& each : survivals.all) {
    Json off;
    for (std::size_t i = 0; i < each.off.size(); ++i) off[survivals.transforms[i]] = each.off[i];
    all.push_back({{"scene", each.scene},
                   {"contender", each.contender},
                   {"setting", each.setting},
                   {"off", off},
                   {"exact", each.exact ? Json(*each.exact) : Json()}});
  }
  return Json{{"left_out", survivals.missing}, {"pictures", all}}.dump(2) + "\n";
}

} // namespace halftone::bench
