#pragma once
// Halftone's pictures in levels.

#include "levels.h"

#include <halftone/render/render.h>

namespace halftone::bench {

struct Rendered {
  Levels levels;
  render::Statistics statistics;

  /// From the parsed scene to the last row.
  double seconds() const { return statistics.prepare_seconds + statistics.render_seconds; }
};

Rendered rendered(const scene::Scene& scene, const render::Settings& settings);

} // namespace halftone::bench
