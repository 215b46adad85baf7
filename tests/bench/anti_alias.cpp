// T. Whitted, "An improved illumination model for shaded display" (1980), section 4: corners first, squares
// of contrast are subdivided. Contrast is taken where it is seen, in the picture's own levels (D. Mitchell,
// "Generating antialiased images at low sampling densities", 1987), and means are of radiance.

#include "anti_alias.h"

#include <halftone/shade/display.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace halftone::bench {

namespace {

using core::Color;

constexpr int tile = 16; ///< pixels

/// Calls work(x0, y0, x1, y1) for every tile of a grid.
template<typename Work>
void for_tiles(int width, int height, int threads, const Work& work) {
  const int across = (width + tile - 1) / tile, down = (height + tile - 1) / tile;
  std::atomic<int> next{0};
  const auto run = [&] {
    for (int i = next++; i < across * down; i = next++) {
      const int x = i % across * tile, y = i / across * tile;
      work(x, y, std::min(x + tile, width), std::min(y + tile, height));
    }
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads; ++i) helpers.emplace_back(run);
  run();
}

/// Radiance to levels by the nearest entry of a table, near enough to compare; with the straight lines of
/// shade::LevelTable the whole contender takes 4 % longer.
class DisplayTable {
public:
  explicit DisplayTable(const scene::Image& image) : scale_(image.exposure * (entries - 1)) {
    scene::Image unexposed = image;
    unexposed.exposure = 1;
    for (std::size_t i = 0; i < entries; ++i)
      table_[i] = static_cast<float>(
          shade::display_level(static_cast<double>(i) / static_cast<double>(entries - 1), unexposed));
  }
  float level(double radiance) const {
    return table_[static_cast<std::size_t>(std::clamp(radiance * scale_, 0.0, entries - 1.0))];
  }

  bool differ(const std::array<Color, 4>& corners, double contrast) const {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax({corners[0][c], corners[1][c], corners[2][c], corners[3][c]});
      if (level(high) - level(low) > static_cast<float>(contrast)) return true;
    }
    return false;
  }

private:
  static constexpr std::size_t entries = 8192;
  double scale_;
  std::array<float, entries> table_{};
};

/// The subdivision of one pixel after another; keeps its memory.
class PixelSampler {
public:
  PixelSampler(const Adaptive& settings, const DisplayTable& display, const Radiance& radiance)
      : settings_(settings),
        display_(display),
        radiance_(radiance),
        side_(settings.n + 1),
        samples_(static_cast<std::size_t>(side_ * side_)),
        known_(samples_.size(), 0) {}

  /// alert: near a boundary.
  Color pixel(int x, int y, const std::array<Color, 4>& corners, bool alert) {
    coarsest_ = alert ? settings_.n / settings_.least : settings_.n;
    x_ = x;
    y_ = y;
    ++stamp_;
    const int n = settings_.n;
    set(0, 0, corners[0]);
    set(n, 0, corners[1]);
    set(0, n, corners[2]);
    set(n, n, corners[3]);
    return mean(0, 0, n);
  }

private:
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * side_ + i); }
  void set(int i, int j, const Color& color) {
    samples_[index(i, j)] = color;
    known_[index(i, j)] = stamp_;
  }
  Color sample(int i, int j) {
    if (known_[index(i, j)] != stamp_)
      set(i, j,
          radiance_(x_ + static_cast<double>(i) / settings_.n, y_ + static_cast<double>(j) / settings_.n));
    return samples_[index(i, j)];
  }

  Color mean(int i, int j, int size) {
    const std::array<Color, 4> corners{sample(i, j), sample(i + size, j), sample(i, j + size),
                                       sample(i + size, j + size)};
    if (size > 1 && (size > coarsest_ || display_.differ(corners, settings_.contrast))) {
      const int half = size / 2;
      return 0.25 * (mean(i, j, half) + mean(i + half, j, half) + mean(i, j + half, half) +
                     mean(i + half, j + half, half));
    }
    return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  }

  Adaptive settings_;
  const DisplayTable& display_;
  const Radiance& radiance_;
  int side_;
  std::vector<Color> samples_;
  std::vector<std::uint32_t> known_; ///< the stamp of the pixel whose sample it is
  std::uint32_t stamp_ = 0;
  int coarsest_ = 1; ///< squares above this size are quartered in any case
  int x_ = 0;
  int y_ = 0;
};

/// In [0, 1), by a hash of the bits (C. Wellons' "prospector", lowbias32).
double scattered(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352dU;
  seed ^= seed >> 15;
  seed *= 0x846ca68bU;
  seed ^= seed >> 16;
  return seed / 4294967296.0;
}

} // namespace

std::vector<Color> sample_adaptively(const scene::Image& image, const Adaptive& settings, int threads,
                                     const Radiance& radiance) {
  const DisplayTable display(image);
  const int across = image.width + 1;
  std::vector<Color> corners(static_cast<std::size_t>(across) * static_cast<std::size_t>(image.height + 1));
  const auto corner = [&](int x, int y) -> Color& {
    return corners[static_cast<std::size_t>(y) * static_cast<std::size_t>(across) +
                   static_cast<std::size_t>(x)];
  };
  for_tiles(across, image.height + 1, threads, [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) corner(x, y) = radiance(x, y);
  });
  const auto corners_of = [&](int x, int y) {
    return std::array<Color, 4>{corner(x, y), corner(x + 1, y), corner(x, y + 1), corner(x + 1, y + 1)};
  };
  std::vector<std::uint8_t> differ(static_cast<std::size_t>(image.width) *
                                   static_cast<std::size_t>(image.height));
  const auto differs = [&](int x, int y) -> std::uint8_t& {
    return differ[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                  static_cast<std::size_t>(x)];
  };
  for_tiles(image.width, image.height, threads, [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) differs(x, y) = display.differ(corners_of(x, y), settings.contrast);
  });
  const auto is_near_boundary = [&](int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u)
        if (differs(u, v)) return true;
    return false;
  };
  std::vector<Color> picture(static_cast<std::size_t>(image.width) * image.height);
  for_tiles(image.width, image.height, threads, [&](int x0, int y0, int x1, int y1) {
    PixelSampler sampler(settings, display, radiance);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        picture[static_cast<std::size_t>(y) * image.width + x] =
            sampler.pixel(x, y, corners_of(x, y), is_near_boundary(x, y));
  });
  return picture;
}

std::vector<Color> sample_evenly(const scene::Image& image, int n, bool stratified, int threads,
                                 const Radiance& radiance) {
  std::vector<Color> picture(static_cast<std::size_t>(image.width) * image.height);
  for_tiles(image.width, image.height, threads, [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        Color sum{0};
        auto seed = static_cast<std::uint32_t>((y * image.width + x) * n * n * 2);
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i, seed += 2) {
            const double u = stratified ? scattered(seed) : 0.5, v = stratified ? scattered(seed + 1) : 0.5;
            sum += radiance(x + (i + u) / n, y + (j + v) / n);
          }
        picture[static_cast<std::size_t>(y) * image.width + x] = sum / static_cast<double>(n * n);
      }
  });
  return picture;
}

} // namespace halftone::bench
