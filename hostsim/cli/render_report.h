#pragma once
// What a render counted and how long it took, for people and for programs.

#include <halftone/render/render.h>

#include <string>

namespace halftone::cli {

struct RenderReport {
  int width = 0;
  int height = 0;
  render::Statistics statistics;
  double device_seconds = 0; ///< sending, verifying and reading back
};

/// Lines of text, the last one ended.
std::string for_people(const RenderReport& report);

/// One JSON object with the keys of docs/json.md.
std::string as_json(const RenderReport& report);

} // namespace halftone::cli
