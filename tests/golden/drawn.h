#pragma once
// A scene drawn, and how far it is from a picture of another program.

#include <halftone/render/render.h>

#include <string>

namespace halftone::test {

struct Drawn {
  render::Statistics statistics;
  double rmse = 0; ///< in 8-bit levels
  int largest = 0;
  double over_4 = 0; ///< share of pixels off by more than 4 levels
};

/// scenes/SCENE.toml beside tests/golden/GOLDEN.png.
Drawn draw(const std::string& scene, const std::string& golden, const render::Settings& settings);

} // namespace halftone::test
