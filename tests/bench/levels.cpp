#include "levels.h"

#include <halftone/shade/display.h>

#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace halftone::bench {

Levels empty_levels(const scene::Image& image) {
  return {
      image.width, image.height,
      std::vector<float>(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))};
}

void set_pixel(Levels& levels, int x, int y, const core::Color& radiance, const scene::Image& image) {
  const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(levels.width) +
                              static_cast<std::size_t>(x));
  for (int c = 0; c < 3; ++c)
    levels.rgb[at + static_cast<std::size_t>(c)] =
        static_cast<float>(shade::display_level(radiance[c], image));
}

Levels levels_of(std::span<const core::Color> radiance, const scene::Image& image) {
  Levels levels = empty_levels(image);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      set_pixel(levels, x, y, radiance[static_cast<std::size_t>(y) * image.width + x], image);
  return levels;
}

double rmse(const Levels& a, const Levels& b) {
  if (a.width != b.width || a.height != b.height) throw std::runtime_error("pictures of different sizes");
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double off = static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i]);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(a.rgb.size()));
}

png::Picture rounded(const Levels& levels) {
  png::Picture picture{levels.width, levels.height, {}};
  picture.rgb.reserve(levels.rgb.size());
  for (const float level : levels.rgb)
    picture.rgb.push_back(static_cast<std::uint8_t>(std::floor(level + 0.5F)));
  return picture;
}

Levels unrounded(const png::Picture& picture) {
  Levels levels{picture.width, picture.height, {}};
  levels.rgb.assign(picture.rgb.begin(), picture.rgb.end());
  return levels;
}

void write_levels(const std::filesystem::path& file, const Levels& levels) {
  std::ofstream out(file, std::ios::binary);
  const std::array<int, 2> size{levels.width, levels.height};
  out.write(reinterpret_cast<const char*>(size.data()), sizeof size);
  out.write(reinterpret_cast<const char*>(levels.rgb.data()),
            static_cast<std::streamsize>(levels.rgb.size() * sizeof(float)));
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

Levels read_levels(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<int, 2> size{};
  in.read(reinterpret_cast<char*>(size.data()), sizeof size);
  scene::Image image;
  image.width = size[0];
  image.height = size[1];
  if (!in || image.width < 1 || image.height < 1 || image.width > 512 || image.height > 512)
    throw std::runtime_error(file.string() + ": no picture of an earlier run; remove it");
  Levels levels = empty_levels(image);
  in.read(reinterpret_cast<char*>(levels.rgb.data()),
          static_cast<std::streamsize>(levels.rgb.size() * sizeof(float)));
  if (!in) throw std::runtime_error(file.string() + ": cut short; remove it");
  return levels;
}

} // namespace halftone::bench
