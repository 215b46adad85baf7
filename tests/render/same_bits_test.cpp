#include "support/effort.h"
#include "support/skip.h"

#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace halftone;

namespace {

std::vector<core::Color> drawn(const scene::Scene& scene, const render::Settings& settings) {
  std::vector<core::Color> picture;
  render::render(scene, settings, [&](const render::Row& row) {
    picture.insert(picture.end(), row.radiance.begin(), row.radiance.end());
  });
  return picture;
}

} // namespace

TEST_CASE("the ten scenes have the same bits for any threads and vectors", test::long_when_sanitized) {
  std::vector<core::Simd> simds;
  for (const core::Simd simd : {core::Simd::baseline, core::Simd::avx2, core::Simd::avx512})
    if (simd <= core::widest_simd())
      simds.push_back(simd);
    else
      test::skip_anywhere("the processor does not have " + std::string(core::name(simd)));
  for (const std::string name :
       {"opaque", "round", "cyclic", "sliver", "fig9a", "fig9b", "contact", "nested", "mirrors", "inside"}) {
    scene::Scene scene = scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + name + ".toml");
    scene.image.width = 100;
    scene.image.height = name == "round" ? 225 : 75; // eight bands of rows, or three
    for (const std::optional<int> lines : {std::optional<int>{}, std::optional<int>{3}}) {
      const auto settings = [&](int threads, core::Simd simd) {
        return render::Settings{.threads = threads, .lines = lines, .quality = 0.5, .simd = simd};
      };
      const std::vector<core::Color> first = drawn(scene, settings(1, core::Simd::baseline));
      REQUIRE(first.size() == std::size_t{100} * scene.image.height);
      for (const core::Simd simd : simds)
        for (const int threads : {1, 2, 3, 5, 8}) {
          if (threads != 1 && simd != simds.back()) continue;
          INFO(name << ", " << threads << " threads, " << core::name(simd) << ", lines "
                    << lines.value_or(0));
          CHECK(std::ranges::equal(first, drawn(scene, settings(threads, simd))));
        }
    }
  }
}
