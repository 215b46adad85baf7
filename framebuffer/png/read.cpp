#include "libpng.h"

#include <halftone/png/png.h>

#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>

namespace halftone::png {

namespace {

constexpr std::size_t channels = 3;

ReadError failure(const std::filesystem::path& file, const std::string& reason) {
  return ReadError(file.string() + ": " + reason);
}

struct Reader {
  ErrorText error;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

  Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Asks libpng for 8-bit RGB, whatever the file holds. No gamma: samples are taken as they are.
void ask_for_rgb(png_structp png, png_infop info) {
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_strip_alpha(png);
  png_set_gray_to_rgb(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

} // namespace

Picture read(const std::filesystem::path& file) {
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
    throw failure(file, "is a folder");
  const File stream(std::fopen(file.c_str(), "rb"));
  if (!stream) throw failure(file, std::generic_category().message(errno));

  Reader reader;
  if (reader.info == nullptr) throw failure(file, "libpng could not start");
  const bool has_header = succeeds(reader.png, [&] {
    png_init_io(reader.png, stream.get());
    png_set_user_limits(reader.png, longest_side, longest_side);
    png_read_info(reader.png, reader.info);
    ask_for_rgb(reader.png, reader.info);
  });
  if (!has_header) throw failure(file, reader.error.text);

  const std::size_t width = png_get_image_width(reader.png, reader.info);
  const std::size_t height = png_get_image_height(reader.png, reader.info);
  if (png_get_rowbytes(reader.png, reader.info) != width * channels) {
    throw failure(file, "libpng did not make 8-bit RGB of it");
  }
  Picture picture{static_cast<int>(width), static_cast<int>(height),
                  std::vector<std::uint8_t>(width * height * channels)};
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = &picture.rgb[y * width * channels];
  const bool has_picture = succeeds(reader.png, [&] {
    png_read_image(reader.png, rows.data());
    png_read_end(reader.png, nullptr);
  });
  if (!has_picture) throw failure(file, reader.error.text);
  return picture;
}

} // namespace halftone::png
