#pragma once
// Pictures in PNG files, and the difference of two. Knows neither engine nor device. Errors: PngError.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace halftone::png {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb; ///< 3 * width * height, rows from the top
};

/// How the samples are marked: the sRGB chunk, or gAMA 1.
enum class Encoding { srgb, linear };

class ReadError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
class WriteError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads any PNG as 8-bit RGB (grey and palettes expanded, 16 bits reduced, alpha dropped). Throws ReadError.
Picture read(const std::filesystem::path& file);

/// Writes beside the file and renames, so that the file is whole or not there. Throws WriteError.
void write(const std::filesystem::path& file, const Picture& picture, Encoding encoding);

} // namespace halftone::png
