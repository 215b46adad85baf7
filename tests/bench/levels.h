#pragma once
// Pictures as they are compared: in 8-bit levels, before they are rounded.

#include <halftone/png/png.h>
#include <halftone/scene/scene.h>

#include <filesystem>
#include <span>
#include <vector>

namespace halftone::bench {

struct Levels {
  int width = 0;
  int height = 0;
  std::vector<float> rgb; ///< 0 to 255, 3 * width * height, rows from the top
};

Levels empty_levels(const scene::Image& image);

/// Of one pixel, by exposure, clamping and transfer (docs/scene-format.md, section 2).
void set_pixel(Levels& levels, int x, int y, const core::Color& radiance, const scene::Image& image);

/// Of a whole picture, row by row.
Levels levels_of(std::span<const core::Color> radiance, const scene::Image& image);

/// Root mean square error over all channels. Both have the same size.
double rmse(const Levels& a, const Levels& b);

/// Half rounded up.
png::Picture rounded(const Levels& levels);
Levels unrounded(const png::Picture& picture);

/// The bits as they are in memory, for a later run on the same machine.
void write_levels(const std::filesystem::path& file, const Levels& levels);
/// Throws std::runtime_error where the file is not one of those.
Levels read_levels(const std::filesystem::path& file);

} // namespace halftone::bench
