#pragma once
// PNG files of every kind, made from the specification (ISO/IEC 15948) without libpng.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace halftone::test {

using Bytes = std::vector<std::uint8_t>;

enum class ColorType : std::uint8_t { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgb_alpha = 6 };

struct HandMade {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint8_t depth = 8; ///< bits of a sample
  ColorType type = ColorType::rgb;
  bool interlaced = false;
  std::vector<std::uint16_t> samples; ///< row by row; of a palette the indices
  Bytes palette;                      ///< of the PLTE chunk
  Bytes transparency;                 ///< of the tRNS chunk
  Bytes gamma;                        ///< of the gAMA chunk
};

Bytes encode(const HandMade& picture);

/// A chunk with its length and checksum.
Bytes chunk(const std::string& name, const Bytes& data);

void save(const std::filesystem::path& file, const Bytes& bytes);
Bytes load(const std::filesystem::path& file);

} // namespace halftone::test
