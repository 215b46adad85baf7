#pragma once
// Pictures in PNG files. Knows neither engine nor device.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace halftone::png {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb; ///< 3 * width * height, rows from the top

  bool operator==(const Picture&) const = default;
};

/// Files with a longer side are refused before memory is taken for them (192 MB at most).
inline constexpr int longest_side = 8192;

/// How the samples are marked: the sRGB chunk, or gAMA 1.
enum class Encoding { srgb, linear };

/// what() begins with the file's name.
class ReadError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads any PNG as 8-bit RGB (grey and palettes expanded, 16 bits reduced, alpha dropped). The samples are
/// taken as they are, however they are marked. Throws ReadError.
Picture read(const std::filesystem::path& file);

/// The file is whole or as it was (file::write_whole). Throws file::WriteError, also where a side is not from
/// 1 to longest_side or pixels are missing.
void write(const std::filesystem::path& file, const Picture& picture, Encoding encoding);

} // namespace halftone::png
