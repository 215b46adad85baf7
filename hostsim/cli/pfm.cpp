#include "pfm.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace halftone::cli {

std::string encode_pfm(int width, int height, std::span<const core::Color> radiance) {
  const auto row_length = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  assert(radiance.size() == row_length * rows);

  std::string bytes = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
  bytes.reserve(bytes.size() + radiance.size() * 12);
  for (std::size_t y = rows; y-- > 0;)
    for (const core::Color& color : radiance.subspan(y * row_length, row_length))
      for (int channel = 0; channel < 3; ++channel) {
        const auto bits = std::bit_cast<std::uint32_t>(
            static_cast<float>(std::min<double>(color[channel], std::numeric_limits<float>::max())));
        for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(bits >> shift & 0xff));
      }
  return bytes;
}

} // namespace halftone::cli
