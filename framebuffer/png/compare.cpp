#include <halftone/png/compare.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>

namespace halftone::png {

namespace {

constexpr std::size_t channels = 3;

/// Pixels by the largest difference of their channels.
using Histogram = std::array<std::size_t, 256>;

void require_same_size(const Picture& a, const Picture& b) {
  const auto size = [](const Picture& picture) {
    return std::to_string(picture.width) + " x " + std::to_string(picture.height);
  };
  if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size()) {
    throw std::invalid_argument("the pictures differ in size: " + size(a) + " and " + size(b));
  }
  if (a.rgb.empty()) throw std::invalid_argument("the pictures have no pixels");
}

double share_over(const Histogram& histogram, std::size_t level, std::size_t pixels) {
  const auto over = std::span(histogram).subspan(level + 1);
  return static_cast<double>(std::accumulate(over.begin(), over.end(), std::size_t{0})) /
         static_cast<double>(pixels);
}

/// The smallest level that at least 999 pixels of 1000 are not above (nearest rank).
std::size_t percentile_999(const Histogram& histogram, std::size_t pixels) {
  std::size_t level = 0;
  for (std::size_t below = histogram[0]; below * 1000 < pixels * 999; below += histogram[level]) ++level;
  return level;
}

} // namespace

Difference compare(const Picture& a, const Picture& b) {
  require_same_size(a, b);
  const std::size_t pixels = a.rgb.size() / channels;
  Difference difference;
  Histogram histogram{};
  std::size_t sum_of_squares = 0; // at most 3 * 8192^2 * 255^2, exact
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    int largest = 0;
    for (std::size_t i = pixel * channels; i < (pixel + 1) * channels; ++i) {
      const int d = std::abs(a.rgb[i] - b.rgb[i]);
      largest = std::max(largest, d);
      sum_of_squares += static_cast<std::size_t>(d * d);
    }
    ++histogram[static_cast<std::size_t>(largest)];
    if (largest > difference.largest) {
      difference.largest = largest;
      difference.largest_x = static_cast<int>(pixel % static_cast<std::size_t>(a.width));
      difference.largest_y = static_cast<int>(pixel / static_cast<std::size_t>(a.width));
    }
  }
  difference.rmse = std::sqrt(static_cast<double>(sum_of_squares) / static_cast<double>(a.rgb.size()));
  difference.percentile_999 = static_cast<double>(percentile_999(histogram, pixels));
  difference.share_over_1 = share_over(histogram, 1, pixels);
  difference.share_over_4 = share_over(histogram, 4, pixels);
  difference.share_over_16 = share_over(histogram, 16, pixels);
  return difference;
}

Picture difference_picture(const Picture& a, const Picture& b, int gain) {
  require_same_size(a, b);
  Picture picture{a.width, a.height, std::vector<std::uint8_t>(a.rgb.size())};
  std::ranges::transform(a.rgb, b.rgb, picture.rgb.begin(), [gain](int of_a, int of_b) {
    return static_cast<std::uint8_t>(std::clamp(128 + gain * (of_a - of_b), 0, 255));
  });
  return picture;
}

} // namespace halftone::png
