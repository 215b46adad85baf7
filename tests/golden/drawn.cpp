#include "drawn.h"

#include <halftone/png/png.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace halftone::test {

Drawn draw(const std::string& scene, const std::string& golden, const render::Settings& settings) {
  const png::Picture wanted = png::read(HALFTONE_SOURCE_DIR "/tests/golden/" + golden + ".png");
  const auto read = scene::read_scene(HALFTONE_SOURCE_DIR "/scenes/" + scene + ".toml");
  REQUIRE(wanted.width == read.image.width);
  REQUIRE(wanted.height == read.image.height);
  Drawn drawn;
  double sum = 0;
  int pixels_over_4 = 0;
  drawn.statistics = render::render(read, settings, [&](const render::Row& row) {
    for (std::size_t pixel = 0; pixel < row.radiance.size(); ++pixel) {
      int most = 0;
      for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
        const int difference = std::abs(row.rgb[i] - wanted.rgb[row.y * row.rgb.size() + i]);
        sum += difference * difference;
        most = std::max(most, difference);
      }
      drawn.largest = std::max(drawn.largest, most);
      if (most > 4) ++pixels_over_4;
    }
  });
  drawn.rmse = std::sqrt(sum / static_cast<double>(wanted.rgb.size()));
  drawn.over_4 = pixels_over_4 / (1.0 * read.image.width * read.image.height);
  return drawn;
}

} // namespace halftone::test
