#pragma once
// A scene as the TOML text that reads back as the same scene (docs/scene-format.md).

#include <halftone/scene/scene.h>

#include <string>

namespace halftone::convert {

/// Every number is written so that it reads back with the same bits, every key is written out, whatever its
/// default. Polygons are written as the reader projected them, which may move a vertex by its rounding where
/// the file's own were not in one plane.
std::string toml(const scene::Scene& scene);

} // namespace halftone::convert
